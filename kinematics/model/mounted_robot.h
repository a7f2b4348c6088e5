// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Combines two models: the root of `robot` is mounted at X_LB on link `link` of `carrier` (a rail, a gantry, a rotary
/// table), whose joints become external axes of the robot.
///
/// Links, joints and variables of the carrier come first and keep their indices; then one fixed joint; then those of
/// the robot in their order, so that its variable i becomes carrier.dof() + i. The tip is the robot's. The robot's
/// names are kept; a name that the carrier uses too gets the prefix "CARRIER/". The home combines both homes; groups
/// and named poses are dropped. Errors: a model with closed loops, a link that does not exist.
Expected<RobotModel> mountRobot(const RobotModel& carrier, int link, const Pose& X_LB, const RobotModel& robot);

/// The same mechanism with another root link: the joints between the two roots are reversed and keep their positions.
/// Variables keep their indices. Used to make the plate of a positioner the root, so that a robot mounted on the old
/// root works in the frame of the part.
///
/// A reversed joint ends in an additional link ("NAME seen back") without shape. Errors: as above.
Expected<RobotModel> seenFrom(const RobotModel& model, int link);

/// True if a moving joint lies between the model's root and that link.
bool isMoved(const RobotModel& model, int link);

}  // namespace hapticell::kinematics
