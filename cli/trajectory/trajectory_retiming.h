// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// `trajectory retime`: new times along the same path. Errors: an invalid mode, limit or step, a missed promise.
Expected<nlohmann::ordered_json> retimeTrajectory(const trajectory::Trajectory& given,
                                                  const TrajectoryOptions& options);

}  // namespace hapticell::cli
