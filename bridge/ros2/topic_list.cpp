// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/topic_list.h"

#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace hapticell::bridge {

using nlohmann::ordered_json;

ordered_json topicsOf(RosNode& node) {
  struct Counts {
    std::string type;
    int publishers = 0, subscribers = 0;
  };
  std::map<std::string, Counts> topics;
  const auto add = [&](const std::vector<RosEndpoint>& endpoints, int Counts::*count) {
    for (const RosEndpoint& endpoint : endpoints) {
      if (!endpoint.topic.starts_with("rt/")) continue;
      Counts& counts = topics[endpoint.topic.substr(2)];
      counts.type = endpoint.type;
      ++(counts.*count);
    }
  };
  add(node.othersWriters(), &Counts::publishers);
  add(node.othersReaders(), &Counts::subscribers);
  ordered_json list = ordered_json::array();
  for (const auto& [name, counts] : topics)
    list.push_back({{"name", name}, {"type", counts.type}, {"publishers", counts.publishers}, {"subscribers", counts.subscribers}});
  return list;
}

Expected<ordered_json> findTopics(const TopicSearch& search, const std::atomic<bool>& stop) {
  using SearchClock = std::chrono::steady_clock;
  auto node = RosNode::create(search.node);
  HAPTICELL_TRY(node);
  const auto end = SearchClock::now() + std::chrono::duration<double>(search.seconds);
  // Half a second: as often as a list that fills is looked at. Half: more lines than are read; twice: seems to hang.
  auto next = SearchClock::now() + std::chrono::milliseconds(500);
  while (!stop && SearchClock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (!search.progress || SearchClock::now() < next) continue;
    next += std::chrono::milliseconds(500);
    search.progress({{"topics", topicsOf(**node)}});
  }
  return ordered_json{{"topics", topicsOf(**node)}};
}

}  // namespace hapticell::bridge
