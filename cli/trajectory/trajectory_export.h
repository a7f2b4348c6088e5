// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// `trajectory export`: the motion in another format or as a robot's program, read back before it is kept. Errors: what
/// the format cannot store, a missed promise.
Expected<nlohmann::ordered_json> exportTrajectory(const trajectory::Trajectory& given,
                                                  const TrajectoryOptions& options);

}  // namespace hapticell::cli
