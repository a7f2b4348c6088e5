// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Reads a joint motion from a YAML file as ROS 1 and ROS 2 tools write it, in any YAML style: a
/// `trajectory_msgs/JointTrajectory`, also inside another message (RobotTrajectory, DisplayTrajectory, the goal of an
/// action), with times as `{sec, nanosec}`, `{secs, nsecs}` or a number of seconds; the output of `ros2 topic echo` and
/// `rostopic echo` (documents separated by `---`); and a sequence of `sensor_msgs/JointState` messages, timed by their
/// stamps. The result has no poses (`Trajectory::has_poses` is false).
///
/// Errors name file and line: not YAML, no such message or several, a joint named twice, a point with a wrong number of
/// positions, invalid numbers, times that do not increase, a list that the echo truncated.
Expected<Trajectory> readRosYaml(const std::filesystem::path& file);

}  // namespace hapticell::trajectory
