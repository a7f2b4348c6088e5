// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "access/removal_scene.h"

namespace hapticell::access {

/// A straight way out of the box, and what blocks it.
struct StraightWay {
  dvec3 direction_W{0.0, 0.0, 1.0};  ///< Unit.
  double length = 0.0;               ///< m, until the unit's box has left.
  UnitSet blockers = 0;              ///< Movable units that are met, each by itself, whatever else is in the way.
  std::vector<std::size_t> fixed;    ///< Units that cannot go and are met.

  bool isFree() const { return blockers == 0 && fixed.empty(); }
};

/// Which units `unit` meets on the way `length` m along the unit direction from where it stands: exact motion checks of the
/// thinned unit against each. What overlaps it at rest by more than the tolerance is met in every direction.
StraightWay straightWay(const RemovalScene& scene, std::size_t unit, const dvec3& direction_W, double length);

/// The straight ways of a unit along removalDirections(), on all cores: those that a movable unit blocks, or nothing;
/// only those whose blockers contain no other's, the fewest blockers first, then the shortest. Where every way is
/// blocked by a fixed unit, the one with the fewest that is.
std::vector<StraightWay> straightWays(const RemovalScene& scene, std::size_t unit);

/// Units (movable or not) that overlap this one at rest by more than the tolerance.
std::vector<std::size_t> overlappingAtRest(const RemovalScene& scene, std::size_t unit);

}  // namespace hapticell::access
