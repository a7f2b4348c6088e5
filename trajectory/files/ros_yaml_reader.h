// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Reads a motion of joints out of a YAML file as ROS 1 and ROS 2 tools write it, in whatever style YAML allows:
/// a `trajectory_msgs/JointTrajectory`, also inside another message (RobotTrajectory, DisplayTrajectory, an action's
/// goal), with times as `{sec, nanosec}`, `{secs, nsecs}` or a number of seconds; what `ros2 topic echo` and
/// `rostopic echo` print (documents between lines of `---`); and a sequence of `sensor_msgs/JointState` messages, timed
/// by their stamps. The result has no poses (`Trajectory::has_poses` is false).
///
/// Errors name file and line: no YAML, no such message or several, joints named twice, a point with other than one
/// position a joint, invalid numbers, times that do not rise, a list that the echo cut short.
Expected<Trajectory> readRosYaml(const std::filesystem::path& file);

}  // namespace hapticell::trajectory
