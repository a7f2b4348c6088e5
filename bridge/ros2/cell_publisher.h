// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bridge/ros2/ros_node.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// What is published of a cell, and how.
struct PublishOptions {
  RosNodeOptions node;
  std::string workcell, entity;  ///< `entity`: the robot; empty: the only one of the cell.
  std::string motion;            ///< A motion of the robot, in any format that is read; empty: the robot rests.
  std::string server;            ///< HOST:PORT of a haptic server whose stylus is published live; empty: none.
  std::string trajectory_topic;  ///< Where the motion is sent once as a JointTrajectory; empty: nowhere.
  std::string folder;            ///< Where meshes of the robot are written for readers; empty: until the end only.
  double rate_hz = 100.0;        ///< 1 to 1000.
  double seconds = 10.0;         ///< At least so long; 0: until stopped.
  double wait = 5.0;             ///< At most so long for a reader of the trajectory, s.
  bool simulated_clock = false;  ///< /clock and stamps from 0 instead of the time of day.
  bool contacts = false;         ///< Markers of the motion's contacts.
  bool repeat = false;           ///< The motion again and again until `seconds`.
};

/// Publishes until the motion and `seconds` are over, or `stop` is set. Result: `published` and `readers` by topic,
/// `late_5ms` (ticks that came more than 5 ms late), `ticks`, `assumptions`. Errors: the cell, the robot or the motion
/// cannot be used, DDS does not start, no server answers, no reader of the trajectory.
Expected<nlohmann::ordered_json> publishCell(const PublishOptions& options, const std::atomic<bool>& stop);

}  // namespace hapticell::bridge
