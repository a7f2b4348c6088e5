// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::bridge {

/// Which quality of service a topic has, as ROS 2 has it by default.
enum class RosQuality {
  kDefault,     ///< Reliable, the last 10, for those who listen now.
  kTransforms,  ///< Reliable, the last 100.
  kLatched,     ///< Reliable, the last one, also for those who come later (transient local).
  kSensor,      ///< Best effort, the last 10: hears reliable and unreliable writers.
};

struct RosNodeOptions {
  int domain = 0;                  ///< ROS_DOMAIN_ID, 0 to 232.
  bool this_machine_only = false;  ///< Loopback, unicast.
};

/// A participant of ROS 2 in DDS, with writers and readers by topic name. Names are mangled as ROS 2 does: "/tf" is
/// "rt/tf". One thread; DDS has its own ones.
class RosNode {
 public:
  /// Errors: DDS cannot start (no network, a wrong CYCLONEDDS_URI).
  static Expected<std::unique_ptr<RosNode>> create(const RosNodeOptions& options);
  ~RosNode();
  RosNode(const RosNode&) = delete;
  RosNode& operator=(const RosNode&) = delete;

  /// A writer or a reader of a topic; the type's descriptor is that of a topic of ros2_messages.h (contract). Its USER_DATA
  /// announces the hash of the type.
  Expected<dds_entity_t> advertise(const std::string& topic, const dds_topic_descriptor_t& type, RosQuality quality);
  Expected<dds_entity_t> subscribe(const std::string& topic, const dds_topic_descriptor_t& type, RosQuality quality);

  /// Writes a message of the writer's type. Error: what DDS says (a reader that does not keep up for 100 ms).
  Expected<void> write(dds_entity_t writer, const void* message);
  /// Readers of a writer that DDS has found.
  std::size_t readersOf(dds_entity_t writer) const;
  /// Writers that a reader hears.
  std::size_t writersOf(dds_entity_t reader) const;
  /// Waits until every written message was acknowledged by the reliable readers; false after `seconds`.
  bool flush(double seconds);

 private:
  explicit RosNode(dds_entity_t domain, dds_entity_t participant) : domain_(domain), participant_(participant) {}

  dds_entity_t domain_, participant_;
  std::vector<dds_entity_t> writers_;
};

/// "/tf" as DDS names it: "rt/tf".
std::string mangledTopic(const std::string& topic);

}  // namespace hapticell::bridge
