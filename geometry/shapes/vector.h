// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace hapticell {

/// The one vocabulary of 3-D geometry in headers. Metres, radians, newtons; right-handed, Z up, X forward.
using glm::dmat3;
using glm::dquat;
using glm::dvec3;
using glm::fvec3;

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad.

/// True where no coordinate is infinite or no number.
inline bool isFinite(const dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The vector shortened to `limit` where it is longer.
inline dvec3 shortenedTo(const dvec3& v, double limit) {
  const double length = glm::length(v);
  return length > limit ? v * (limit / length) : v;
}

}  // namespace hapticell
