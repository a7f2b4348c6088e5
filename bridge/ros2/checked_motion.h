// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/ros2/ros_conversion.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::bridge {

/// A motion that is to go to a real robot.
struct MotionToSend {
  std::string workcell, entity;  ///< `entity`: the robot; empty: the only one of the cell.
  std::string motion;            ///< Its file, in any format that is read.
  std::string action;            ///< The controller's action, "/arm_controller/follow_joint_trajectory".
  double tool_speed = 0.25;      ///< Greatest speed of the moved frame, m/s; a faster motion is slowed as a whole.
  double joint_share = 1.0;      ///< Greatest share of each joint's own speed limit, 0 to 1; likewise.
};

/// A motion that was checked in its cell as a controller executes it, with the message that carries it.
struct CheckedMotion {
  std::string robot;
  std::unique_ptr<JointTrajectoryMessage> message;
  std::vector<double> start;     ///< First point, by the joints of the message, rad (m).
  std::vector<bool> is_sliding;  ///< Which of these joints are measured in m.
  double duration = 0.0;         ///< s
  double slowed = 1.0;           ///< How many times longer it lasts than its file says.
  double tool_speed = 0.0;       ///< Greatest speed of the moved frame on the path of the controller, m/s; never less.
  double joint_share = 0.0;      ///< Greatest share of a joint's speed limit; 0: no joint has one.
  std::string fastest;           ///< The joint that reaches it.
  double least_clearance = 0.0;  ///< To the cell, m; infinite: nothing is near.
  std::vector<std::string> touching_at_start;  ///< Pairs that touch in the first frame and are not checked.
  std::vector<Text> notes;
  /// Changes with every number of the message and with the action: who confirms the motion names it.
  std::string confirmation;
};

/// Reads the motion, slows it to the limits, and checks it. A controller moves between two points by the cubic polynomial
/// through their positions and speeds; this path is sampled from the message itself, closer than 0.1 mrad (mm) to it, and
/// swept through the cell. Errors: the files; a motion that moves the robot's base or has no joints; contact; a joint
/// beyond its limit.
Expected<CheckedMotion> checkedMotion(const MotionToSend& wanted);

/// What a person confirms, as JSON: `robot`, `duration`, `tool_speed`, `confirmation` and the rest of CheckedMotion.
nlohmann::ordered_json previewOf(const CheckedMotion& motion, const std::string& action);

/// The path of a JointTrajectory with speeds as cubic polynomials, sampled; without poses. Times in s.
/// @pre every point has as many positions and velocities as there are joints, and the times rise
trajectory::Trajectory executedPath(const trajectory_msgs_msg_dds__JointTrajectory_& message);

/// The greatest absolute speed of each joint on that path, rad/s (m/s).
std::vector<double> greatestSpeeds(const trajectory_msgs_msg_dds__JointTrajectory_& message);

}  // namespace hapticell::bridge
