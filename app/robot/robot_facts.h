// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace hapticell::app {

/// Largest distance of a serial robot's tip from the axis of its first revolute joint (from its base, if that joint
/// slides), m: the best of a search over its joints within their limits. 0 for robots with a closed loop or no joints.
double flangeReach(const kinematics::RobotModel& model);

/// Whether `text` matches what a user types to find a robot, in lower case: "kr 16" finds "KUKA KR16-2".
bool matchesSearch(const std::string& text, const std::string& search);

}  // namespace hapticell::app
