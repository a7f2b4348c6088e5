// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/ros2/ros_node.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// What the window exchanges of one robot while the link is on.
struct LiveLinkOptions {
  RosNodeOptions node;
  std::string workcell, entity;  ///< `entity`: the robot; empty: the only one of the cell.
  bool mirror = false;           ///< Hears the robot; else it is published.
  std::string joint_topic = "/joint_states";  ///< Where it is heard.
  double rate_hz = 50.0;                      ///< Messages a second, 1 to 1000.
};

/// Runs until standard input ends or `stop` is set; a JSON object a line in both directions.
///
/// In: `{"joints": [...], "place": [x, y, z, qw, qx, qy, qz]}`, where the robot of the window is; other lines are left
/// out. Out: `{"heard": [...]}`, a number for each variable, at most 30 times a second; and each second `topics[]` of other
/// programs (`name`, `type`, `publishers`, `subscribers`), `heard_hz`, `published{}` and `readers{}` by topic. Result: the
/// last of these. Errors: the cell or the robot cannot be used, DDS does not start.
Expected<nlohmann::ordered_json> runLiveLink(const LiveLinkOptions& options, const std::atomic<bool>& stop);

}  // namespace hapticell::bridge
