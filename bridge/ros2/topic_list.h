// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>

#include "bridge/ros2/ros_node.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// Topics of ROS 2 that other programs publish or read, by name: a list of `name`, `type` (of DDS), `publishers`,
/// `subscribers`.
nlohmann::ordered_json topicsOf(RosNode& node);

/// How long to look for topics, and where.
struct TopicSearch {
  RosNodeOptions node;
  double seconds = 3.0;  ///< Discovery takes about a second; a busy network longer.
  /// Gets the topics found so far, twice a second. May be empty.
  std::function<void(const nlohmann::ordered_json&)> progress{};
};

/// Looks for topics until the time is over or `stop` is set. Result: `topics`. Error: DDS does not start.
Expected<nlohmann::ordered_json> findTopics(const TopicSearch& search, const std::atomic<bool>& stop);

}  // namespace hapticell::bridge
