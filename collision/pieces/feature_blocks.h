// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/pieces/convex_pieces.h"

namespace hapticell::collision {

/// Orders the planes and edges of a piece's hull along a space-filling curve (Morton 1966) and fills its blocks.
/// `real_plane` is reordered with the planes.
void sortIntoBlocks(ConvexPiece& piece);

}  // namespace hapticell::collision
