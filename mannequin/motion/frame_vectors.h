// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/shapes/pose.h"

namespace hapticell::mannequin {

// Directions that the frames of a body are made from.

/// The part of `v` that is square to the unit vector `axis`.
inline dvec3 across(const dvec3& v, const dvec3& axis) {
  return v - glm::dot(v, axis) * axis;
}

/// 0 for what has no length.
inline dvec3 unit(const dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : dvec3(0.0);
}

/// Columns forward, left, up: `up` as given, the left near `left`, which may lie along it.
inline dmat3 frameOf(const dvec3& up, const dvec3& left) {
  const dvec3 z = unit(up);
  dvec3 y = across(left, z);
  if (glm::length(y) < 1e-6) y = across(std::abs(z.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), z);
  y = unit(y);
  return {glm::cross(y, z), y, z};
}

/// The one of the six axes that lies nearest.
inline dvec3 nearestAxis(const dvec3& v) {
  int best = 0;
  for (int k = 1; k < 3; ++k) best = std::abs(v[k]) > std::abs(v[best]) ? k : best;
  dvec3 axis(0.0);
  axis[best] = v[best] < 0.0 ? -1.0 : 1.0;
  return axis;
}

}  // namespace hapticell::mannequin
