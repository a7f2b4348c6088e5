// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/system/error.h"
#include "planning/free_space.h"
#include "planning/plan.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {

struct TimingChoice {
  double sample_s = 0.01;  ///< Between the frames of the motion.
  /// How much of the plan's slack the corners are rounded off by, 0 to 1.
  double rounding = 1.0;
};

/// The plan as the fastest motion within the joints' greatest speeds and accelerations (full speed in 0.25 s; a solid:
/// 0.5 m/s and 2 rad/s), from rest to rest, with the poses of the tool (moved "tcp"), of the solid ("self_origin") or of
/// the whole mannequin ("whole").
/// Corners are rounded off by no more than the slack of the plan lets parts come nearer. Errors: those of
/// trajectory::retimed(), for example a plan that does not move.
Expected<trajectory::Trajectory> timedMotion(const Plan& plan, const FreeSpace& space, const TimingChoice& choice = {});

}  // namespace hapticell::planning
