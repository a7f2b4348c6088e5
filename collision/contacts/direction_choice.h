// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/pieces/separating_directions.h"

namespace hapticell::collision {

/// One moving piece against one piece of an obstacle: they are apart if one of the directions holds.
struct PieceGroup {
  std::uint32_t environment_part = 0;
  std::uint32_t moving_piece = 0;
  std::uint32_t environment_piece = 0;
  std::vector<SeparatingDirection> directions;
  std::vector<std::uint32_t> chosen;  ///< Indices into directions; the first is the best at the body's pose.
};

/// max over all directions of gap + nhat . d: positive if the pieces are apart after the translation d (world, m).
double separationAt(const PieceGroup& group, const dvec3& d_W);

/// Chooses, for each group of one moving part, the directions that keep free places within `reach` (m) free: first the
/// best direction at the body's pose, then one for each tested free place, faces of the mesh first. Leaving directions
/// out can only reduce the free space.
void chooseDirections(std::vector<PieceGroup>& groups, const DirectionLimits& limits);

}  // namespace hapticell::collision
