// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// `trajectory simplify`: fewer frames within the tolerances. Errors: tolerances that are not positive, a missed
/// promise.
Expected<nlohmann::ordered_json> simplifyTrajectory(const trajectory::Trajectory& given,
                                                    const TrajectoryOptions& options);

/// `trajectory smooth`: removes hand tremor, within the tolerances; errors likewise.
Expected<nlohmann::ordered_json> smoothTrajectory(const trajectory::Trajectory& given,
                                                  const TrajectoryOptions& options);

}  // namespace hapticell::cli
