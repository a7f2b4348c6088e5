// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/ros2/ros_node.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// What is taken from ROS 2, and where it goes. Empty: not listened for.
struct ListenOptions {
  RosNodeOptions node;
  std::string motion;       ///< File for the joint states that come, .htraj or .csv.
  std::string trajectory;   ///< File for the first JointTrajectory.
  std::string description;  ///< File for the robot's description, .urdf.
  std::string workcell, mirrored;  ///< A cell, and the file for it with what was heard.
  std::string entity;              ///< Its robot, which takes the last joint state; empty: none.
  bool objects = false;            ///< It takes the collision objects of /planning_scene and /collision_object.
  std::string joint_topic = "/joint_states", trajectory_topic = "/joint_trajectory";
  std::string description_topic = "/robot_description";
  double seconds = 10.0;  ///< At most so long; with only a trajectory or a description, until they came.
};

/// Listens, then writes the files. Result: `joint_states`, `frames`, `writers` (programs heard on the topic of joints),
/// `objects`, `notes`. Errors: nothing came of what was asked for, joints that the robot does not have, files that cannot
/// be written; nothing is written then.
Expected<nlohmann::ordered_json> listen(const ListenOptions& options, const std::atomic<bool>& stop);

}  // namespace hapticell::bridge
