// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// A ROS 2 `trajectory_msgs/JointTrajectory` as YAML: joints (rad, m) with velocities by central differences, times
/// from the first frame on. Errors: a trajectory without joints. Its reader is readRosYaml().
Expected<std::string> toRosText(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
