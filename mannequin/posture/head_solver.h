// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body/figure.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// The result of a motion of the head.
struct HeadResult {
  Posture posture;
  double position_error = 0.0;     ///< m, of the point between the eyes.
  double orientation_error = 0.0;  ///< rad
};

/// One tick of a drag of the head (1 kHz): the point between the eyes and the head's axes move towards X_WEyes (frame
/// of the head's segment, origin between the eyes) by the neck's nine joints and, unless locked, the spine's nine; at
/// most about 2 degrees in any joint, within hard limits, never farther from the target than `from`. Pelvis, legs and
/// the angles of the arms do not change, so hands move with the trunk. Damped least squares; the same input gives the
/// same bits; no allocation.
HeadResult followHead(const Figure& figure, const Posture& from, const Pose& X_WEyes, bool trunk_locked);

/// The pose of the eyes: the head's axes, origin between the eyes.
Pose eyesFrame(const Figure& figure, const FigurePose& pose);

}  // namespace hapticell::mannequin
