// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/programs/writing/program_export.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::cli {

/// Limits from the command line: lists of one number per joint, or one number for all.
struct RobotLimitOptions {
  std::string robot;  ///< A file or library:NAME; its speeds are used if `velocity` is empty.
  std::vector<double> velocity, acceleration, jerk;
};

/// Limits for each joint of the trajectory (for one without joints: x, y, z and the rotation about them). Missing
/// limits are assumed and listed in `assumptions`.
Expected<trajectory::MotionLimits> limitsFor(const trajectory::Trajectory& trajectory, const RobotLimitOptions& options,
                                             std::vector<Text>& assumptions);

/// Gives `program` the configuration data of `robot` in the notation of `format`, and adds a note to `notes` if there
/// are no such data. Does nothing without a robot or without joints.
Expected<void> addConfigurations(const trajectory::Trajectory& trajectory, const std::string& robot,
                                 trajectory::ProgramFormat format, trajectory::ProgramOptions& program,
                                 std::vector<Text>& notes);

}  // namespace hapticell::cli
