// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/error.h"
#include "kinematics/robot_model.h"

namespace hapticell::cli {

/// A robot from a file with the tip that a command works on.
struct RobotWithTip {
  kinematics::RobotModel model;
  int tip = -1;
  std::vector<int> variables;  ///< Of the model, those that move the tip, from base to tip.

  std::vector<std::string> jointNames() const;  ///< Of these variables.
};

/// Reads a robot from a file or "library:NAME" and finds its tip by name (empty: RobotModel::defaultTip()). Warnings go
/// to standard error.
Expected<RobotWithTip> readRobotWithTip(const std::string& file, const std::string& tip_name);

}  // namespace hapticell::cli
