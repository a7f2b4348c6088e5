// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/triangle_distance.h"

#include <algorithm>
#include <cmath>

namespace hapticell::collision {

namespace {

/// Height over length of triangles whose normal is not trusted, the root of double's rounding (1e-16); what is
/// neglected is as thin as this. Half: normals of rounding; twice: 20 nm on 1 m.
constexpr double kNeedle = 1e-8;

double squaredLength(const dvec3& v) {
  return glm::dot(v, v);
}

struct Segment {
  dvec3 start;
  dvec3 along;
};

Segment edge(const Corners& corners, std::size_t i) {
  return {corners[i], corners[(i + 1) % 3] - corners[i]};
}

double clampedRatio(double numerator, double denominator) {
  return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
}

void improveBySegments(const Segment& first, const Segment& second, NearestPair& best) {
  const dvec3 r = first.start - second.start;
  const double a = squaredLength(first.along), e = squaredLength(second.along);
  const double b = glm::dot(first.along, second.along);
  const double c = glm::dot(first.along, r), f = glm::dot(second.along, r);
  double s = clampedRatio(b * f - c * e, a * e - b * b);
  double t = (e > 0.0) ? (b * s + f) / e : 0.0;
  if (t < 0.0 || t > 1.0 || e == 0.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = clampedRatio(b * t - c, a);
  }
  const dvec3 p = first.start + s * first.along, q = second.start + t * second.along;
  const double squared = squaredLength(p - q);
  if (squared < best.squared) best = {squared, p, q};
}

/// Heights of the corners over a plane through `origin`, times the length of the plane's normal.
dvec3 heights(const Corners& corners, const dvec3& origin, const dvec3& normal) {
  return {glm::dot(corners[0] - origin, normal), glm::dot(corners[1] - origin, normal),
          glm::dot(corners[2] - origin, normal)};
}

/// The square of the least height when all corners are on one side of the plane; else 0.
double clearanceSquared(const dvec3& h, double normal_squared) {
  const double lowest = std::min({h.x, h.y, h.z}), highest = std::max({h.x, h.y, h.z});
  const double gap = std::max({lowest, -highest, 0.0});  // One of the two at most is above 0.
  return normal_squared > 0.0 ? gap * gap / normal_squared : 0.0;
}

bool projectsInside(const Corners& face, const dvec3& normal, const dvec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (glm::dot(glm::cross(face[(i + 1) % 3] - face[i], point - face[i]), normal) < 0.0) return false;
  }
  return true;
}

struct Face {
  const Corners& corners;
  dvec3 normal;
  double normal_squared;
};

/// Corners of `other` straight above `face`; with `face_is_second` the point on the face is q, else p.
void improveByCorners(const Face& face, const Corners& other, const dvec3& h, bool face_is_second, NearestPair& best) {
  if (face.normal_squared <= 0.0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double height = h[static_cast<glm::length_t>(i)];
    const double squared = height * height / face.normal_squared;
    if (squared >= best.squared || !projectsInside(face.corners, face.normal, other[i])) continue;
    const dvec3 foot = other[i] - face.normal * (height / face.normal_squared);
    best = face_is_second ? NearestPair{squared, other[i], foot} : NearestPair{squared, foot, other[i]};
  }
}

/// An edge of `other` whose ends are on both sides of `face` and that passes through it: a common point.
bool pierces(const Face& face, const Corners& other, const dvec3& h, dvec3& common) {
  if (face.normal_squared <= 0.0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double from = h[static_cast<glm::length_t>(i)], to = h[static_cast<glm::length_t>((i + 1) % 3)];
    if ((from > 0.0) == (to > 0.0) || from == to) continue;
    common = other[i] + (from / (from - to)) * (other[(i + 1) % 3] - other[i]);
    if (projectsInside(face.corners, face.normal, common)) return true;
  }
  return false;
}

Face faceOf(const Corners& corners) {
  const dvec3 along = corners[1] - corners[0], across = corners[2] - corners[0];
  const dvec3 normal = glm::cross(along, across);
  const double square = squaredLength(normal), scale = std::max(squaredLength(along), squaredLength(across));
  // A needle's normal is rounding and would put its plane anywhere: a needle is its edges.
  return {corners, normal, square > kNeedle * kNeedle * scale * scale ? square : 0.0};
}

}  // namespace

bool improveTriangleDistance(const Corners& first, const Corners& second, NearestPair& best) {
  const double before = best.squared;
  const Face first_face = faceOf(first);
  const dvec3 h_second = heights(second, first[0], first_face.normal);
  const double above_first = clearanceSquared(h_second, first_face.normal_squared);
  if (above_first >= before) return false;
  const Face second_face = faceOf(second);
  const dvec3 h_first = heights(first, second[0], second_face.normal);
  const double above_second = clearanceSquared(h_first, second_face.normal_squared);
  if (above_second >= before) return false;

  dvec3 common;
  if (above_first == 0.0 && above_second == 0.0 &&
      (pierces(first_face, second, h_second, common) || pierces(second_face, first, h_first, common))) {
    best = {0.0, common, common};
    return before > 0.0;
  }
  improveByCorners(first_face, second, h_second, false, best);
  improveByCorners(second_face, first, h_first, true, best);
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment edge_i = edge(first, i);
    for (std::size_t j = 0; j < 3; ++j) improveBySegments(edge_i, edge(second, j), best);
  }
  return best.squared < before;
}

NearestPair triangleDistance(const Corners& first, const Corners& second) {
  NearestPair best;
  improveTriangleDistance(first, second, best);
  return best;
}

dvec3 closestPointOnTriangle(const Corners& corners, const dvec3& point) {
  const Face face = faceOf(corners);
  if (face.normal_squared > 0.0 && projectsInside(corners, face.normal, point)) {
    return point - face.normal * (glm::dot(point - corners[0], face.normal) / face.normal_squared);
  }
  dvec3 nearest = corners[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Segment side = edge(corners, i);
    const double s = clampedRatio(glm::dot(point - side.start, side.along), squaredLength(side.along));
    const dvec3 candidate = side.start + s * side.along;
    const double squared = squaredLength(point - candidate);
    if (squared < least) {
      least = squared;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace hapticell::collision
