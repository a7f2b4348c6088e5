// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// One model of two: the root of `robot` stands at X_LB on link `link` of `carrier` (a rail, a gantry, a rotary table),
/// whose joints become external axes of the robot.
///
/// Links, joints and variables of the carrier come first and keep their indices; then one fixed joint; then the robot's
/// in their order, so that its variable i is carrier.dof() + i. The tip is the robot's. Its names stay; a name of the
/// carrier that is there twice gets the carrier's name and a slash in front. Home is where both are at home; groups and
/// named poses are dropped. Refused: a model with closed loops, a link that is not there.
Expected<RobotModel> mountRobot(const RobotModel& carrier, int link, const Pose& X_LB, const RobotModel& robot);

/// The same mechanism told from another link: that one is the root, and the joints between go the other way round with
/// the positions that they had. Variables keep their indices. A positioner that carries the part is told so from its
/// plate: what is mounted on its old root then works in the part's frame.
///
/// A joint that is turned round ends in a link of its own ("NAME seen back"), without shape. Refused: as above.
Expected<RobotModel> seenFrom(const RobotModel& model, int link);

/// True where a joint that moves lies between the model's root and that link.
bool isMoved(const RobotModel& model, int link);

}  // namespace hapticell::kinematics
