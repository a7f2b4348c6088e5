// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "exchange/mcap/mcap_reader.h"
#include "exchange/recordings/recording.h"
#include "geometry/system/error.h"

namespace hapticell::exchange {

/// Messages of an MCAP file by topic, decoded with a sentence where one cannot be. The content must outlive it.
class TopicMessages {
 public:
  TopicMessages(const McapContent& content, std::string name);

  const std::string& fileName() const { return name_; }
  /// In the order of the file; empty: no such topic.
  const std::vector<const McapMessage*>& of(std::string_view topic) const;
  /// Topics of a type ("sensor_msgs/msg/JointState") in CDR that have messages, by name.
  std::vector<std::string> ofType(std::string_view type) const;
  bool has(std::string_view topic) const { return !of(topic).empty(); }

  /// About message `i` of a topic.
  tl::unexpected<Error> undecodable(std::string_view topic, std::size_t i, Text found = "a message that does not fit its type",
                                    Text expected = "a message of the topic's type") const;
  /// A JSON message, an object.
  Expected<nlohmann::json> json(std::string_view topic, std::size_t i) const;

 private:
  const McapContent& content_;
  std::string name_;
  std::map<std::string, std::vector<const McapMessage*>, std::less<>> topics_;
};

/// As it came where it is a unit one to rounding, made one within a thousandth; nothing: no rotation, or not finite.
std::optional<Pose> usablePose(const Pose& pose);

/// The one motion of another program's file (recording_reader.h).
Expected<trajectory::Trajectory> foreignMotion(const TopicMessages& messages, const std::string& topic,
                                               std::vector<Text>& notes);

}  // namespace hapticell::exchange
