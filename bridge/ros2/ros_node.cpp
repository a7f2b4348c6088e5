// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/ros_node.h"

#include <cmath>

#include "bridge/ros2/type_hashes.h"
#include "geometry/system/assertion.h"

namespace hapticell::bridge {

namespace {

/// Loopback without multicast: participants are looked for at the first twenty places of the domain.
constexpr const char* kThisMachine =
    "<General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces><AllowMulticast>false</AllowMulticast>"
    "</General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>20</MaxAutoParticipantIndex>"
    "<Peers><Peer address='127.0.0.1'/></Peers></Discovery>";

/// A quality of service that is freed with its owner.
using Qualities = std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)>;

/// With the hash of the type as ROS 2 Iron and later announce it (REP 2016).
Qualities qualitiesOf(RosQuality quality, const dds_topic_descriptor_t& type) {
  Qualities qualities(dds_create_qos(), dds_delete_qos);
  const std::string_view hash = typeHash(type.m_typename);
  HAPTICELL_DEMAND(!hash.empty());
  const std::string user_data = "typehash=" + std::string(hash) + ";";
  dds_qset_userdata(qualities.get(), user_data.data(), user_data.size());
  const bool is_sensor = quality == RosQuality::kSensor;
  // 100 ms are what ROS 2 has; half: a busy reader costs messages sooner, twice: a publisher hangs longer.
  dds_qset_reliability(qualities.get(), is_sensor ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       DDS_MSECS(100));
  const bool is_latched = quality == RosQuality::kLatched;
  dds_qset_durability(qualities.get(), is_latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  std::int32_t depth = quality == RosQuality::kTransforms ? 100 : 10;
  if (is_latched) depth = 1;
  dds_qset_history(qualities.get(), DDS_HISTORY_KEEP_LAST, depth);
  return qualities;
}

tl::unexpected<Error> ddsProblem(dds_return_t code, const std::string& what) {
  return makeError({what, "", std::string(dds_strretcode(-code)), "DDS to work",
                    "Check the network interface and CYCLONEDDS_URI."});
}

}  // namespace

std::string mangledTopic(const std::string& topic) {
  return topic.starts_with("/") ? "rt" + topic : "rt/" + topic;
}

Expected<std::unique_ptr<RosNode>> RosNode::create(const RosNodeOptions& options) {
  dds_entity_t domain = 0;
  if (options.this_machine_only) {
    domain = dds_create_domain(static_cast<dds_domainid_t>(options.domain), kThisMachine);
    if (domain < 0) return ddsProblem(domain, "DDS");
  }
  const dds_entity_t participant = dds_create_participant(static_cast<dds_domainid_t>(options.domain), nullptr, nullptr);
  if (participant < 0) {
    if (domain > 0) dds_delete(domain);
    return ddsProblem(participant, "DDS");
  }
  return std::unique_ptr<RosNode>(new RosNode(domain, participant));
}

RosNode::~RosNode() {
  dds_delete(participant_);
  if (domain_ > 0) dds_delete(domain_);
}

Expected<dds_entity_t> RosNode::advertise(const std::string& topic, const dds_topic_descriptor_t& type,
                                          RosQuality quality) {
  const auto qualities = qualitiesOf(quality, type);
  const dds_entity_t at = dds_create_topic(participant_, &type, mangledTopic(topic).c_str(), nullptr, nullptr);
  if (at < 0) return ddsProblem(at, topic);
  const dds_entity_t writer = dds_create_writer(participant_, at, qualities.get(), nullptr);
  if (writer < 0) return ddsProblem(writer, topic);
  writers_.push_back(writer);
  return writer;
}

Expected<dds_entity_t> RosNode::subscribe(const std::string& topic, const dds_topic_descriptor_t& type,
                                          RosQuality quality) {
  const auto qualities = qualitiesOf(quality, type);
  const dds_entity_t at = dds_create_topic(participant_, &type, mangledTopic(topic).c_str(), nullptr, nullptr);
  if (at < 0) return ddsProblem(at, topic);
  if (quality == RosQuality::kSensor) dds_qset_history(qualities.get(), DDS_HISTORY_KEEP_LAST, 1000);
  const dds_entity_t reader = dds_create_reader(participant_, at, qualities.get(), nullptr);
  if (reader < 0) return ddsProblem(reader, topic);
  return reader;
}

Expected<void> RosNode::write(dds_entity_t writer, const void* message) {
  const dds_return_t code = dds_write(writer, message);
  if (code < 0) return ddsProblem(code, "DDS");
  return {};
}

std::size_t RosNode::readersOf(dds_entity_t writer) const {
  const dds_return_t count = dds_get_matched_subscriptions(writer, nullptr, 0);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t RosNode::writersOf(dds_entity_t reader) const {
  const dds_return_t count = dds_get_matched_publications(reader, nullptr, 0);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

bool RosNode::flush(double seconds) {
  for (const dds_entity_t writer : writers_)
    if (dds_wait_for_acks(writer, static_cast<dds_duration_t>(std::llround(1e9 * seconds))) != DDS_RETCODE_OK) return false;
  return true;
}

}  // namespace hapticell::bridge
