// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bridge/ros2/checked_motion.h"
#include "bridge/ros2/ros_node.h"
#include "bridge/ros2/rpc_client.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// How a motion goes to a real robot.
struct SendOptions {
  RosNodeOptions node;
  MotionToSend motion;
  /// That of the preview (CheckedMotion::confirmation) that a person confirmed. Empty: the preview is made, nothing is
  /// sent.
  std::string confirmation;
  std::optional<RpcForm> services{};           ///< Empty: found out by the maker of the server's DDS.
  std::string joint_topic = "/joint_states";   ///< Where the robot says where it is.
  std::string hold;                            ///< HOST:PORT of a haptic server: moves while a button of the stylus is held.
  bool texts = false;                          ///< The result has `reason_text` too, the reason as packed() makes it.
  double wait = 5.0;                           ///< For the controller, the robot's joints and the button; s.
  /// Gets the progress while the robot moves: `t` (s), `state`, `joints`. May be empty.
  std::function<void(const nlohmann::ordered_json&)> progress{};
};

/// Checks the motion, then sends it as a goal of FollowJointTrajectory and follows it to its end.
///
/// The safety case is docs/user/safety.md. Sent is only what was checked and confirmed: the motion is read and checked
/// again, and its confirmation must be the given one. The robot must be at the first point (0.01 rad, 1 mm). The goal is
/// cancelled once `stop` is set, the button is released, the haptic server is lost, joint states are 0.5 s old, the robot
/// is 0.2 rad (20 mm) from the motion's path at that time, or the motion lasts 5 s longer than it should. Result: the
/// preview, `sent`, and if sent, `outcome` ("succeeded", "canceled", "aborted", "rejected"), `reason` why it was
/// cancelled, `error_code`, `error`, `feedbacks`, `seconds`. Errors: all that stops it before anything is sent; and,
/// after it, a controller that does not confirm its end within 5 s.
Expected<nlohmann::ordered_json> sendMotion(const SendOptions& options, const std::atomic<bool>& stop);

}  // namespace hapticell::bridge
