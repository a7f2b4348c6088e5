// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"
#include "kinematics/model/robot_model.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::cli {

/// A robot from a file with the tip that a command works on.
struct RobotWithTip {
  kinematics::RobotModel model;
  int tip = -1;
  std::vector<int> variables;  ///< Of the model, those that move the tip, from base to tip.

  std::vector<std::string> jointNames() const;  ///< Of these variables.
};

/// Reads a robot from a file, a xacro with its arguments ("FILE,NAME:=VALUE,…") or "library:NAME" and finds its tip by
/// name (empty: RobotModel::defaultTip()). Warnings go to standard error. With kKinematics no mesh is read where the
/// format allows it.
Expected<RobotWithTip> readRobotWithTip(const std::string& file, const std::string& tip_name,
                                        workcell::RobotContent content = workcell::RobotContent::kAll);

/// External axes of a robot, as the command line says them.
struct AxisOptions {
  std::string on;       ///< FILE[,link=L][,pose=x,y,z,qw,qx,qy,qz]: what the robot stands on.
  std::string part_on;  ///< The same: what carries the part.
};

/// The robot with its external axes in one model (kinematics::mountRobot): first those that carry the part, then those
/// that carry the robot, then its own joints. Its root is the part's plate, else the root of what the robot stands on.
/// `link` is what the robot's root (the part) stands on, the default tip where not said; `pose` of `on` is the robot's
/// root in that link, of `part_on` the positioner's root in the root of the rest.
Expected<void> addExternalAxes(const AxisOptions& options, RobotWithTip& robot);

}  // namespace hapticell::cli
