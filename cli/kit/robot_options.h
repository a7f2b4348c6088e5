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
  std::vector<int> variables;  ///< Of the model: those that move the tip, from base to tip.

  std::vector<std::string> jointNames() const;  ///< Of these variables.
};

/// Reads a robot from a file, a xacro with its arguments ("FILE,NAME:=VALUE,…") or "library:NAME" and finds its tip by
/// name (empty: RobotModel::defaultTip()). Warnings are printed on standard error. With kKinematics no mesh is read, if
/// the format allows it.
Expected<RobotWithTip> readRobotWithTip(const std::string& file, const std::string& tip_name,
                                        workcell::RobotContent content = workcell::RobotContent::kAll);

/// External axes of a robot, as given on the command line.
struct AxisOptions {
  std::string on;       ///< FILE[,link=L][,pose=x,y,z,qw,qx,qy,qz]: what carries the robot.
  std::string part_on;  ///< The same: what carries the part.
};

/// Puts the robot with its external axes into one model (kinematics::mountRobot): first those that carry the part, then
/// those that carry the robot, then its own joints. Its root is the part's plate, else the root of what carries the
/// robot. `link` is the link that carries the robot's root (or the part), by default the default tip; `pose` of `on` is
/// the robot's root in that link, `pose` of `part_on` the positioner's root in the root of the rest.
Expected<void> addExternalAxes(const AxisOptions& options, RobotWithTip& robot);

}  // namespace hapticell::cli
