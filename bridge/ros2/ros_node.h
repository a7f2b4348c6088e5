// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <deque>
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

/// A writer or a reader of another program, as discovery announces it.
struct RosEndpoint {
  std::string topic, type;     ///< As DDS names them: "rt/tf", "tf2_msgs::msg::dds_::TFMessage_".
  std::uint16_t vendor = 0;    ///< Maker of its DDS (RTPS vendor id): 0x010f Fast DDS, 0x0110 Cyclone DDS.
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

  /// The same with the name of the topic as DDS has it ("rq/add_two_intsRequest"), and with the name of the type that is
  /// announced.
  Expected<dds_entity_t> openWriter(const std::string& dds_topic, const dds_topic_descriptor_t& type, RosQuality quality,
                                    const char* type_name);
  Expected<dds_entity_t> openReader(const std::string& dds_topic, const dds_topic_descriptor_t& type, RosQuality quality,
                                    const char* type_name);

  /// Writes a message of the writer's type. Error: what DDS says (a reader that does not keep up for 100 ms).
  Expected<void> write(dds_entity_t writer, const void* message);
  /// Readers of a writer that DDS has found.
  std::size_t readersOf(dds_entity_t writer) const;
  /// Writers that a reader hears.
  std::size_t writersOf(dds_entity_t reader) const;
  /// A number of the writer that no other entity of this process has.
  std::uint64_t handleOf(dds_entity_t writer) const;
  /// Readers (or writers) of other programs that discovery found so far.
  std::vector<RosEndpoint> othersReaders();
  std::vector<RosEndpoint> othersWriters();
  /// Waits until every written message was acknowledged by the reliable readers; false after `seconds`.
  bool flush(double seconds);

 private:
  explicit RosNode(dds_entity_t domain, dds_entity_t participant) : domain_(domain), participant_(participant) {}

  Expected<dds_entity_t> openTopic(const std::string& dds_topic, const dds_topic_descriptor_t& type, const char* type_name);
  std::vector<RosEndpoint> othersIn(dds_entity_t builtin_topic, dds_entity_t& reader);

  dds_entity_t domain_, participant_;
  dds_entity_t found_readers_ = 0, found_writers_ = 0;  ///< Readers of what discovery finds; 0: not asked yet.
  std::vector<dds_entity_t> writers_;
  std::deque<dds_topic_descriptor_t> descriptors_;
};

/// "/tf" as DDS names it: "rt/tf".
std::string mangledTopic(const std::string& topic);

}  // namespace hapticell::bridge
