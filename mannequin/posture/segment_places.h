// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/sine_cosine.h"

namespace hapticell::mannequin {

/// Orientations of the ball joints' segments in their parents: left and right shoulder, left and right hip.
using BallRotations = std::array<dmat3, 4>;

/// Computes the frames of all segments below the pelvis, whose pose is already in `pose`.
void placeSegments(const Figure& figure, const SineCosine& sc, const BallRotations& balls, FigurePose& pose);

}  // namespace hapticell::mannequin
