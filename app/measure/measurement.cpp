// SPDX-License-Identifier: Apache-2.0
#include "app/measure/measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hapticell::app {
namespace {

using collision::SurfaceType;
// rad: rounding of files and places; 0.1 mm at 1 m. Half: parallel faces of rounded files get no distance; twice: 0.2
// mm at 1 m is not seen.
constexpr double kParallel = 1e-4;

bool isPlane(const PickedFeature& f) {
  return f.kind == FeatureKind::kFace && f.surface_W.type == SurfaceType::kPlane;
}

bool isPoint(const PickedFeature& f) {
  return f.kind == FeatureKind::kVertex || (f.kind == FeatureKind::kFace && f.surface_W.type == SurfaceType::kFreeForm);
}

/// The direction that an angle is taken of; empty if there is no direction.
std::optional<dvec3> directionOf(const PickedFeature& f) {
  if (f.kind == FeatureKind::kVertex) return std::nullopt;
  if (f.kind == FeatureKind::kEdge) return f.edge == EdgeShape::kCurve ? std::nullopt : std::optional<dvec3>(f.axis_W);
  const auto type = f.surface_W.type;
  if (type == SurfaceType::kSphere || type == SurfaceType::kFreeForm) return std::nullopt;
  return f.surface_W.axis_M;
}

/// Planes and circles are turned by a right angle against lines and axes.
bool isAcross(const PickedFeature& f) {
  return isPlane(f) || (f.kind == FeatureKind::kEdge && f.edge == EdgeShape::kCircle);
}

struct Axis {
  dvec3 p_W, d_W;
  bool unbounded = true;
};

/// Centre and axis of what is round.
std::optional<Axis> axisOf(const PickedFeature& f) {
  if (f.kind == FeatureKind::kEdge && f.edge == EdgeShape::kCircle) return Axis{f.center_W, f.axis_W, false};
  if (f.kind != FeatureKind::kFace) return std::nullopt;
  const auto& s = f.surface_W;
  if (s.type == SurfaceType::kSphere || s.type == SurfaceType::kTorus) return Axis{s.p_M, s.axis_M, false};
  if (s.type == SurfaceType::kCylinder || s.type == SurfaceType::kCone) return Axis{s.p_M, s.axis_M, true};
  return std::nullopt;
}

/// Nearest points of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
std::pair<dvec3, dvec3> nearest(const dvec3& p1, const dvec3& q1, const dvec3& p2, const dvec3& q2) {
  const dvec3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = glm::dot(d1, d1), e = glm::dot(d2, d2), f = glm::dot(d2, r);
  double s = 0.0, t = 0.0;
  if (a > 0.0 && e > 0.0) {
    const double c = glm::dot(d1, r), b = glm::dot(d1, d2), denominator = a * e - b * b;
    if (denominator > 1e-12 * a * e) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
    t = (b * s + f) / e;
    if (t < 0.0) s = std::clamp(-c / a, 0.0, 1.0);
    if (t > 1.0) s = std::clamp((b - c) / a, 0.0, 1.0);
    t = std::clamp(t, 0.0, 1.0);
  } else if (a > 0.0) {
    s = std::clamp(glm::dot(p2 - p1, d1) / a, 0.0, 1.0);
  } else if (e > 0.0) {
    t = std::clamp(f / e, 0.0, 1.0);
  }
  return {p1 + s * d1, p2 + t * d2};
}

/// The feature as polylines: a point is one of length 0; faces that are no points have none.
std::vector<std::vector<dvec3>> linesOf(const PickedFeature& f) {
  if (isPoint(f)) return {{f.p_WQ, f.p_WQ}};
  return f.kind == FeatureKind::kEdge ? f.outline_W : std::vector<std::vector<dvec3>>{};
}

bool takeNearest(const std::vector<std::vector<dvec3>>& a, const std::vector<std::vector<dvec3>>& b, Measurement& m) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& one : a)
    for (const auto& other : b)
      for (std::size_t i = 0; i + 1 < one.size(); ++i)
        for (std::size_t j = 0; j + 1 < other.size(); ++j) {
          const auto [p, q] = nearest(one[i], one[i + 1], other[j], other[j + 1]);
          if (const double d = glm::length(q - p); d < least) least = d, m.p_WA = p, m.p_WB = q;
        }
  if (std::isfinite(least)) m.distance = least;
  return std::isfinite(least);
}

/// From a picked place square onto the other's plane.
void takeToPlane(const dvec3& p_W, const PickedFeature& plane, bool plane_is_b, Measurement& m) {
  const dvec3 n = plane.surface_W.axis_M;
  const dvec3 foot = p_W - glm::dot(p_W - plane.surface_W.p_M, n) * n;
  m.p_WA = plane_is_b ? p_W : foot;
  m.p_WB = plane_is_b ? foot : p_W;
  m.distance = glm::length(m.p_WB - m.p_WA);
}

std::optional<double> angleBetween(const PickedFeature& a, const PickedFeature& b) {
  const auto d = directionOf(a), e = directionOf(b);
  if (!d || !e) return std::nullopt;
  const double between = std::atan2(glm::length(glm::cross(*d, *e)), std::abs(glm::dot(*d, *e)));
  return isAcross(a) == isAcross(b) ? between : std::acos(0.0) - between;
}

std::optional<double> axesApart(const PickedFeature& a, const PickedFeature& b) {
  const auto x = axisOf(a), y = axisOf(b);
  if (!x || !y) return std::nullopt;
  const dvec3 between = y->p_W - x->p_W;
  if (!x->unbounded && !y->unbounded) return glm::length(between);
  const dvec3& along = x->unbounded ? x->d_W : y->d_W;
  if (x->unbounded && y->unbounded && glm::length(glm::cross(x->d_W, y->d_W)) > kParallel) return std::nullopt;
  return glm::length(between - glm::dot(between, along) * along);
}

double lengthOf(const std::vector<std::vector<dvec3>>& lines) {
  double length = 0.0;
  for (const auto& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::length(line[i + 1] - line[i]);
  return length;
}

}  // namespace

Measurement measure(const PickedFeature& feature) {
  Measurement m;
  m.p_WA = m.p_WB = feature.p_WQ;
  if (feature.kind == FeatureKind::kEdge) {
    m.length = lengthOf(feature.outline_W);
    if (feature.edge == EdgeShape::kCircle) m.radius = feature.radius;
  } else if (feature.kind == FeatureKind::kFace &&
             (feature.surface_W.type == SurfaceType::kCylinder || feature.surface_W.type == SurfaceType::kSphere)) {
    m.radius = feature.surface_W.radius;
  }
  return m;
}

Measurement measure(const PickedFeature& a, const PickedFeature& b) {
  Measurement m;
  m.angle = angleBetween(a, b);
  m.between_axes = axesApart(a, b);
  const bool parallel = m.angle && *m.angle < kParallel;
  if (takeNearest(linesOf(a), linesOf(b), m)) return m;
  if (isPlane(b) && (isPoint(a) || parallel)) {
    takeToPlane(a.p_WQ, b, true, m);
  } else if (isPlane(a) && (isPoint(b) || parallel)) {
    takeToPlane(b.p_WQ, a, false, m);
  } else {
    m.between_picks = true;
    m.p_WA = a.p_WQ;
    m.p_WB = b.p_WQ;
    m.distance = glm::length(m.p_WB - m.p_WA);
  }
  return m;
}

}  // namespace hapticell::app
