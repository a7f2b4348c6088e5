// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/error.h"
#include "trajectory/trajectory.h"

namespace hapticell::trajectory {

/// A ROS 2 `trajectory_msgs/JointTrajectory` as YAML: joints (rad, m) with velocities by central differences, times
/// from the first frame on. Errors: a trajectory without joints.
Expected<std::string> toRosText(const Trajectory& trajectory);

/// Reads what toRosText writes (and the same message written by hand in block or flow style): joint names, positions
/// and times. Poses stay at identity.
Expected<Trajectory> readRosTrajectory(const std::filesystem::path& file);

}  // namespace hapticell::trajectory
