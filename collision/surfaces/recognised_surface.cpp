// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/recognised_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/system/assertion.h"

namespace hapticell::collision {
namespace {

dvec3 anyPerpendicular(const dvec3& n) {
  const dvec3 other = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(n, other));
}

/// A point in the coordinates of an axis: height along it and the radial direction.
struct AxisView {
  double height = 0.0;
  double distance = 0.0;
  dvec3 radial{1.0, 0.0, 0.0};
};

AxisView aroundAxis(const SurfaceShape& shape, const dvec3& p) {
  const dvec3 v = p - shape.p_M;
  AxisView view;
  view.height = glm::dot(v, shape.axis_M);
  const dvec3 off = v - view.height * shape.axis_M;
  view.distance = glm::length(off);
  view.radial = view.distance > 1e-15 ? off / view.distance : anyPerpendicular(shape.axis_M);
  return view;
}

double inverse(double length) {
  return 1.0 / std::max(length, 1e-9);
}

SurfaceView coneView(const SurfaceShape& s, const dvec3& p) {
  const AxisView a = aroundAxis(s, p);
  const double sine = std::sin(s.half_angle), cosine = std::cos(s.half_angle);
  SurfaceView view;
  const double f = a.distance * cosine - a.height * sine;
  view.value = s.side * f;
  view.nhat_M = s.side * (cosine * a.radial - sine * s.axis_M);
  view.t1_M = glm::cross(s.axis_M, a.radial);
  view.k1 = s.side * cosine * inverse(a.distance - f * cosine);
  return view;
}

SurfaceView torusView(const SurfaceShape& s, const dvec3& p) {
  const AxisView a = aroundAxis(s, p);
  const double out = a.distance - s.major_radius;
  const double d = std::hypot(out, a.height);
  const double cosine = d > 1e-15 ? out / d : 1.0, sine = d > 1e-15 ? a.height / d : 0.0;
  SurfaceView view;
  view.value = s.side * (d - s.radius);
  const dvec3 n = cosine * a.radial + sine * s.axis_M;
  view.nhat_M = s.side * n;
  view.t1_M = glm::cross(s.axis_M, a.radial);
  view.k1 = s.side * cosine * inverse(s.major_radius + s.radius * cosine);
  view.k2 = s.side * inverse(s.radius);
  return view;
}

}  // namespace

double signedDistance(const SurfaceShape& s, const dvec3& p) {
  switch (s.type) {
    case SurfaceType::kPlane:
      return glm::dot(s.axis_M, p - s.p_M);
    case SurfaceType::kSphere:
      return s.side * (glm::length(p - s.p_M) - s.radius);
    case SurfaceType::kCylinder: {
      const dvec3 v = p - s.p_M;
      return s.side * (glm::length(v - glm::dot(v, s.axis_M) * s.axis_M) - s.radius);
    }
    case SurfaceType::kCone: {
      const dvec3 v = p - s.p_M;
      const double height = glm::dot(v, s.axis_M);
      return s.side * (glm::length(v - height * s.axis_M) * std::cos(s.half_angle) - height * std::sin(s.half_angle));
    }
    case SurfaceType::kTorus: {
      const dvec3 v = p - s.p_M;
      const double height = glm::dot(v, s.axis_M);
      return s.side * (std::hypot(glm::length(v - height * s.axis_M) - s.major_radius, height) - s.radius);
    }
    case SurfaceType::kFreeForm:
      break;
  }
  HAPTICELL_DEMAND(false);
  return 0.0;
}

SurfaceView viewFrom(const SurfaceShape& s, const dvec3& p) {
  SurfaceView view;
  switch (s.type) {
    case SurfaceType::kPlane:
      view.value = glm::dot(s.axis_M, p - s.p_M);
      view.nhat_M = s.axis_M;
      view.t1_M = anyPerpendicular(s.axis_M);
      return view;
    case SurfaceType::kSphere: {
      const dvec3 v = p - s.p_M;
      const double d = glm::length(v);
      view.value = s.side * (d - s.radius);
      view.nhat_M = s.side * (d > 1e-15 ? v / d : s.axis_M);
      view.t1_M = anyPerpendicular(view.nhat_M);
      view.k1 = view.k2 = s.side * inverse(s.radius);
      return view;
    }
    case SurfaceType::kCylinder: {
      const AxisView a = aroundAxis(s, p);
      view.value = s.side * (a.distance - s.radius);
      view.nhat_M = s.side * a.radial;
      view.t1_M = glm::cross(s.axis_M, a.radial);
      view.k1 = s.side * inverse(s.radius);
      return view;
    }
    case SurfaceType::kCone:
      return coneView(s, p);
    case SurfaceType::kTorus:
      return torusView(s, p);
    case SurfaceType::kFreeForm:
      break;
  }
  HAPTICELL_DEMAND(false);
  return view;
}

double smallestRadius(const SurfaceShape& s) {
  if (s.type == SurfaceType::kPlane || s.type == SurfaceType::kFreeForm || s.type == SurfaceType::kCone)
    return std::numeric_limits<double>::infinity();
  return s.radius;
}

double RecognisedSurface::recognisedShare() const {
  double all = 0.0, known = 0.0;
  for (const SurfaceRegion& region : regions) {
    all += region.area;
    if (region.shape.type != SurfaceType::kFreeForm) known += region.area;
  }
  return all > 0.0 ? known / all : 1.0;
}

double RecognisedSurface::greatestSagitta() const {
  double greatest = 0.0;
  for (const SurfaceRegion& region : regions) greatest = std::max(greatest, region.sagitta);
  return greatest;
}

}  // namespace hapticell::collision
