// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/time_optimal.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// The largest share of the limits that differences of a motion's frames use, evenly timed by `step` s, standing before
/// and after. Higher ones are taken over several steps where rounding would show.
LimitUse useOfFrames(const Trajectory& frames, double step, const MotionLimits& limits, LimitedBy by);

}  // namespace hapticell::trajectory
