// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// A ROS 2 `trajectory_msgs/JointTrajectory` as YAML: joints (rad, m), velocities by central differences, times
/// relative to the first frame. Errors: a trajectory without joints. readRosYaml() reads it back.
Expected<std::string> toRosText(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
