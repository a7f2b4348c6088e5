// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace hapticell {

/// The types of 3-D geometry that all headers use. Metres, radians, newtons; right-handed, Z up, X forward.
using glm::dmat3;
using glm::dquat;
using glm::dvec3;
using glm::fvec3;

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad.

/// True if no coordinate is infinite or NaN.
inline bool isFinite(const dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The vector, shortened to `limit` if it is longer.
inline dvec3 shortenedTo(const dvec3& v, double limit) {
  const double length = glm::length(v);
  return length > limit ? v * (limit / length) : v;
}

}  // namespace hapticell
