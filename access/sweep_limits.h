// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/bounds.h"

namespace hapticell::access {

/// A motion check ends after 400 queries; it is continued so many times. Half: a long slide in a narrow gap may count as
/// blocked; twice: twice the time there.
inline constexpr int kMostContinued = 20;
/// m beyond the clearance: what stops a part farther away than this is the end of the queries, not contact. Half and
/// twice: both are far from kLeastClearance (1e-6) and from any gap that is meant.
inline constexpr double kStopped = 5e-6;

/// Whether a plane between two boxes keeps them apart.
inline bool areApart(const geometry::Bounds& a, const geometry::Bounds& b) {
  const dvec3 gap = glm::max(a.min - b.max, b.min - a.max);
  return gap.x > 0.0 || gap.y > 0.0 || gap.z > 0.0;
}

}  // namespace hapticell::access
