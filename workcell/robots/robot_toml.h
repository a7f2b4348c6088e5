// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// What a robot.toml says of the robot besides how it moves.
struct RobotSheet {
  std::string name, maker, kind, source;
  double payload = 0.0;  ///< kg; 0: not said.
  double reach = 0.0;    ///< m; 0: not said.
};

/// A robot read from a robot.toml.
struct TomlRobot {
  kinematics::RobotModel model;
  RobotSheet sheet;
  std::vector<ToolFrame> tools;
  Pose X_FB;  ///< Where the file puts its root; only SDF says.
};

/// Reads a robot from a robot.toml (docs/user/formats.md): OPW parameters, a Denavit-Hartenberg table, a chain of
/// frames, a Delta, a hexapod, or a URDF whose loops it closes. Its body is generated from its dimensions.
///
/// Errors name file, line, what was found and what was expected: what toml++ cannot parse, keys that are missing, of
/// the wrong kind or not known, numbers out of range, limits reversed, an axis of length zero, lists of unequal length,
/// loops that cannot be closed. Nothing throws. Any thread.
Expected<TomlRobot> readRobotToml(const std::filesystem::path& path, Diagnostics& diagnostics);

/// The data sheet alone, without making the robot: for lists.
Expected<RobotSheet> readRobotSheet(const std::filesystem::path& path);

}  // namespace hapticell::workcell
