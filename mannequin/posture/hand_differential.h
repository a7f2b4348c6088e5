// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

/// How every segment's frame moves (m, rad, in the world) for a unit motion of a frame M that the driven hand carries:
/// three translations, then three turns about M's origin.
using HandDifferential = std::array<std::array<Twist, 6>, kSegmentCount>;

/// First-order answer of the whole body to a small motion of the task's hand (the left one for a held object), with the
/// task's locks, the feet standing and joints kept off the limits they sit at. `X_WM` is where M is now.
HandDifferential differentiateHand(const Figure& figure, const Posture& posture, const PostureTask& task, Side driven,
                                   const Pose& X_WM);

}  // namespace hapticell::mannequin
