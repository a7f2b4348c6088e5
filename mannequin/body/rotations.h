// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/shapes/vector.h"

namespace hapticell::mannequin {

inline dmat3 aboutX(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {dvec3(1, 0, 0), dvec3(0, c, s), dvec3(0, -s, c)};
}
inline dmat3 aboutY(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {dvec3(c, 0, -s), dvec3(0, 1, 0), dvec3(s, 0, c)};
}
inline dmat3 aboutZ(double a) {
  const double s = std::sin(a), c = std::cos(a);
  return {dvec3(c, s, 0), dvec3(-s, c, 0), dvec3(0, 0, 1)};
}

/// From 0 to pi; for vectors of any length above 0; exact for small angles too.
inline double angleBetween(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The least rotation from unit vector a to unit vector b (for opposite vectors: close to some half turn).
inline dmat3 leastTurn(const dvec3& a, const dvec3& b) {
  const dvec3 v = glm::cross(a, b);
  const double w = 1.0 / std::max(1e-9, 1.0 + glm::dot(a, b));
  const dmat3 K(dvec3(0.0, v.z, -v.y), dvec3(-v.z, 0.0, v.x), dvec3(v.y, -v.x, 0.0));
  return dmat3(1.0) + K + w * (K * K);
}

/// The same orientation mirrored at the plane y = 0, so that right limbs can be treated as left ones.
inline dmat3 mirroredRotation(const dmat3& R) {
  return {R[0] * dvec3(1, -1, 1), R[1] * dvec3(-1, 1, -1), R[2] * dvec3(1, -1, 1)};
}

/// +1 for the left, -1 for the right.
template <typename SideType>
double outwardSign(SideType side) {
  return side == SideType::kLeft ? 1.0 : -1.0;
}

}  // namespace hapticell::mannequin
