// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace hapticell::app {

/// How far from the axis of its first turning joint (from its base, where that slides) a serial robot's tip comes, m:
/// the best of a search over its joints within their limits. 0 for robots with a closure and for those without joints.
double flangeReach(const kinematics::RobotModel& model);

/// What a user types to find a robot, in lower case: "kr 16" finds "KUKA KR16-2".
bool matchesSearch(const std::string& text, const std::string& search);

}  // namespace hapticell::app
