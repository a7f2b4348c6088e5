// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// `{position, angle}`, m and rad.
nlohmann::ordered_json distanceJson(const trajectory::PoseDistance& distance);

/// Frames that say that their pose and joints were made each by itself.
std::size_t posesApart(const trajectory::Trajectory& trajectory);

/// Says in `notes`, a list of texts, where poses and joints of one frame need not agree.
void noteApart(const trajectory::Trajectory& trajectory, nlohmann::ordered_json& notes);

/// What `trajectory info` tells: size, bounds, speeds, tremor, joints, points. Errors: a robot that cannot be read or
/// has other joints.
Expected<nlohmann::ordered_json> trajectoryInfo(const trajectory::Trajectory& given, const TrajectoryOptions& options);

}  // namespace hapticell::cli
