// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/contacts/direction_choice.h"

namespace hapticell::collision {

struct ReductionTolerance {
  double absolute = 1e-6;  ///< Metres.
  double relative = 0.0;   ///< Share of the removed group's gap, and of the part of a tightened group's gap above
                           ///< `boundary`.
  double turning = 1.0;  ///< Share of the turning that is considered; below 1, turned bodies may wrongly count as free.
  double boundary = 0.0;   ///< m: the gap that is felt as contact. Directions in contact are never tightened.
};

/// Removes groups that others imply within the tolerance, for translations up to the reach and turns up to the maximum
/// about p_WC: two facets of a bore imply the facets between them.
///
/// To compensate, directions that replace others are tightened (SeparatingDirection::tightened) by at most the
/// tolerance. So no place becomes free that was not free before.
void reduceGroups(std::vector<PieceGroup>& groups, const DirectionLimits& limits, const dvec3& p_WC,
                  const ReductionTolerance& tolerance);

}  // namespace hapticell::collision
