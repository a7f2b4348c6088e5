// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

/// The motion of every segment's frame (m, rad, in the world) for a unit motion of a frame M that the driven hand
/// carries: three translations, then three rotations about M's origin.
using HandDifferential = std::array<std::array<Twist, 6>, kSegmentCount>;

/// First-order response of the whole body to a small motion of the task's hand (the left one for a held object), with
/// the task's locks, the feet fixed and joints kept off their active limits. `X_WM` is the present pose of M.
HandDifferential differentiateHand(const Figure& figure, const Posture& posture, const PostureTask& task, Side driven,
                                   const Pose& X_WM);

}  // namespace hapticell::mannequin
