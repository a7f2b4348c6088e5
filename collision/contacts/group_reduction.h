// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/contacts/direction_choice.h"

namespace hapticell::collision {

struct ReductionTolerance {
  double absolute = 1e-6;  ///< Metres.
  double relative = 0.0;   ///< Of the gap that the removed group has, and of what a tightened one has above `boundary`.
  double turning = 1.0;  ///< Share of the turning that is looked at; below 1 turned bodies may be called free wrongly.
  double boundary = 0.0;   ///< m: the gap that is felt as contact. What is touched is never tightened.
};

/// Removes groups that others imply within the tolerance, for translations up to the reach and turns up to the
/// maximum about p_WC: two facets of a bore imply those between them.
///
/// What is lost that way is made good: the directions that stand for others are tightened
/// (SeparatingDirection::tightened) by at most the tolerance, so that nothing is called free that was not before.
void reduceGroups(std::vector<PieceGroup>& groups, const DirectionLimits& limits, const dvec3& p_WC,
                  const ReductionTolerance& tolerance);

}  // namespace hapticell::collision
