// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "collision/trees/triangle_distance.h"

namespace hapticell::collision {

/// The least gap along an axis, from B's triangle up to A's.
inline double gapAlong(const dvec3& axis, const Corners& a, const Corners& b) {
  const double low = std::min({glm::dot(axis, a[0]), glm::dot(axis, a[1]), glm::dot(axis, a[2])});
  const double high = std::max({glm::dot(axis, b[0]), glm::dot(axis, b[1]), glm::dot(axis, b[2])});
  return low - high;
}

}  // namespace hapticell::collision
