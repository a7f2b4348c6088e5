// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// `{position, angle}`, m and rad.
nlohmann::ordered_json distanceJson(const trajectory::PoseDistance& distance);

/// Number of frames that are marked as having independent pose and joints.
std::size_t posesApart(const trajectory::Trajectory& trajectory);

/// Adds to `notes`, a list of texts, where pose and joints of a frame need not agree.
void noteApart(const trajectory::Trajectory& trajectory, nlohmann::ordered_json& notes);

/// Output of `trajectory info`: size, bounds, speeds, tremor, joints, frames. Errors: a robot that cannot be read or
/// has other joints.
Expected<nlohmann::ordered_json> trajectoryInfo(const trajectory::Trajectory& given, const TrajectoryOptions& options);

}  // namespace hapticell::cli
