// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trajectory/motion/trajectory.h"
#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {

/// The largest share of the limits that the differences of a motion's frames use; frames are spaced by `step` s, at
/// rest before and after. Higher differences are taken over several steps if rounding would dominate.
LimitUse useOfFrames(const Trajectory& frames, double step, const MotionLimits& limits, LimitedBy by);

}  // namespace hapticell::trajectory
