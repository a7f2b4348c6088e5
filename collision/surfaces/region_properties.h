// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Fills residual, sagitta, area, mean normal, borders and trims of every region; shapes, triangles and region_of are
/// given.
void measureRegions(RecognisedSurface& surface);

}  // namespace hapticell::collision
