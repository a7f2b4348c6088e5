// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/pieces/separating_directions.h"

namespace hapticell::collision {

/// One moving piece against one piece of an obstacle: apart where one of the directions holds.
struct PieceGroup {
  std::uint32_t environment_part = 0;
  std::uint32_t moving_piece = 0;
  std::uint32_t environment_piece = 0;
  std::vector<SeparatingDirection> directions;
  std::vector<std::uint32_t> chosen;  ///< Indices into directions; the first is the best where the body stands.
};

/// max over all directions of gap + nhat . d: positive where the pieces are apart after the translation d (world, m).
double separationAt(const PieceGroup& group, const dvec3& d_W);

/// Chooses for each group of one moving part the directions that free places within `reach` (m) need: the best where
/// the body stands, then for every place tried that is free of all groups one that says so, faces of the mesh first.
/// Fewer directions than all of them only ever take room away.
void chooseDirections(std::vector<PieceGroup>& groups, const DirectionLimits& limits);

}  // namespace hapticell::collision
