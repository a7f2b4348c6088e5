// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/kept_result.h"
#include "cli/trajectory/tool_poses.h"
#include "cli/trajectory/trajectory_options.h"
#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// A motion completed with its missing poses, and the forward kinematics of the given robot. No tool: no robot was
/// given, the motion has no joints, or its poses are not those of this robot.
struct MotionOfRobot {
  trajectory::Trajectory motion;
  std::optional<ToolPoses> tool;
};

/// `assumptions` get what was assumed. Errors: a robot that cannot be read or has other joints.
Expected<MotionOfRobot> withRobot(const trajectory::Trajectory& given, const TrajectoryOptions& options,
                                  std::vector<Text>& assumptions);

/// Adds to `promises`, if there is a robot: every pose in the file `written` is where the joints of its frame put the
/// tool (1e-6 m, rad), or is marked as independent.
Expected<Promises> withPosesByJoints(Expected<Promises> promises, const std::optional<ToolPoses>& tool,
                                     const std::filesystem::path& written);

/// Writes `trajectory` to the requested output, in the format of its extension, after `measure` found all promises kept
/// (kept_result.h). Error also: an extension that is not one of a trajectory.
Expected<void> saveKept(const trajectory::Trajectory& trajectory, const TrajectoryOptions& options,
                        const MeasureFile& measure, nlohmann::ordered_json& result);

}  // namespace hapticell::cli
