// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// The data of a robot.toml except for its motion.
struct RobotSheet {
  std::string name, maker, kind, source;
  double payload = 0.0;  ///< kg; 0: not stated.
  double reach = 0.0;    ///< m; 0: not stated.
};

/// A robot read from a robot.toml.
struct TomlRobot {
  kinematics::RobotModel model;
  RobotSheet sheet;
  std::vector<ToolFrame> tools;
  Pose X_FB;  ///< The pose of its root in the file; only SDF states it.
};

/// Reads a robot from a robot.toml (docs/user/formats.md): OPW parameters, a Denavit-Hartenberg table, a chain of
/// frames, a Delta, a hexapod, or a URDF whose loops it closes. The body is generated from the dimensions.
///
/// Errors name file, line, what was found and what was expected: text that toml++ cannot parse; keys that are missing,
/// of the wrong kind or unknown; numbers out of range; reversed limits; an axis of length zero; lists of unequal
/// length; loops that cannot be closed. Does not throw. Any thread.
Expected<TomlRobot> readRobotToml(const std::filesystem::path& path, Diagnostics& diagnostics);

/// Only the data sheet, without making the robot: for lists.
Expected<RobotSheet> readRobotSheet(const std::filesystem::path& path);

}  // namespace hapticell::workcell
