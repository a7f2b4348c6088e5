// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::kinematics {
struct RobotModel;
}

namespace hapticell::app {

/// The word (MotionFormat::word) of the format that the controller of this robot reads, by the names in its model; ROS 2
/// if they name no maker.
QString usualFormat(const kinematics::RobotModel& model);

}  // namespace hapticell::app
