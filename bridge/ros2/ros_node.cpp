// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/ros_node.h"

#include <algorithm>
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
Qualities qualitiesOf(RosQuality quality, const char* type_name) {
  Qualities qualities(dds_create_qos(), dds_delete_qos);
  const std::string_view hash = typeHash(type_name);
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
  return makeError({.file = what,
                    .found = std::string(dds_strretcode(-code)),
                    .expected = "DDS to work",
                    .fix = "Check the network interface and CYCLONEDDS_URI."});
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
  return openWriter(mangledTopic(topic), type, quality, type.m_typename);
}

Expected<dds_entity_t> RosNode::subscribe(const std::string& topic, const dds_topic_descriptor_t& type,
                                          RosQuality quality) {
  return openReader(mangledTopic(topic), type, quality, type.m_typename);
}

Expected<dds_entity_t> RosNode::openTopic(const std::string& dds_topic, const dds_topic_descriptor_t& type,
                                          const char* type_name) {
  dds_topic_descriptor_t& named = descriptors_.emplace_back(type);
  named.m_typename = type_name;
  const dds_entity_t topic = dds_create_topic(participant_, &named, dds_topic.c_str(), nullptr, nullptr);
  if (topic < 0) return ddsProblem(topic, dds_topic);
  return topic;
}

Expected<dds_entity_t> RosNode::openWriter(const std::string& dds_topic, const dds_topic_descriptor_t& type,
                                           RosQuality quality, const char* type_name) {
  const auto qualities = qualitiesOf(quality, type_name);
  const auto topic = openTopic(dds_topic, type, type_name);
  HAPTICELL_TRY(topic);
  const dds_entity_t writer = dds_create_writer(participant_, *topic, qualities.get(), nullptr);
  if (writer < 0) return ddsProblem(writer, dds_topic);
  writers_.push_back(writer);
  return writer;
}

Expected<dds_entity_t> RosNode::openReader(const std::string& dds_topic, const dds_topic_descriptor_t& type,
                                           RosQuality quality, const char* type_name) {
  const auto qualities = qualitiesOf(quality, type_name);
  const auto topic = openTopic(dds_topic, type, type_name);
  HAPTICELL_TRY(topic);
  if (quality == RosQuality::kSensor) dds_qset_history(qualities.get(), DDS_HISTORY_KEEP_LAST, 1000);
  const dds_entity_t reader = dds_create_reader(participant_, *topic, qualities.get(), nullptr);
  if (reader < 0) return ddsProblem(reader, dds_topic);
  return reader;
}

std::uint64_t RosNode::handleOf(dds_entity_t writer) const {
  dds_instance_handle_t handle = 0;
  dds_get_instance_handle(writer, &handle);
  return handle;
}

std::vector<RosEndpoint> RosNode::othersReaders() {
  return othersIn(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, found_readers_);
}

std::vector<RosEndpoint> RosNode::othersWriters() {
  return othersIn(DDS_BUILTIN_TOPIC_DCPSPUBLICATION, found_writers_);
}

std::vector<RosEndpoint> RosNode::othersIn(dds_entity_t builtin_topic, dds_entity_t& reader) {
  if (reader <= 0) reader = dds_create_reader(participant_, builtin_topic, nullptr, nullptr);
  dds_guid_t own{};
  dds_get_guid(participant_, &own);
  std::vector<RosEndpoint> others;
  // More than any robot has; half and twice: the list of a larger network is cut sooner or later.
  constexpr std::uint32_t kMost = 4096;
  std::vector<void*> samples(kMost, nullptr);
  std::vector<dds_sample_info_t> infos(kMost);
  const dds_return_t count =
      reader > 0 ? dds_read_mask(reader, samples.data(), infos.data(), kMost, kMost, DDS_ALIVE_INSTANCE_STATE) : 0;
  for (dds_return_t i = 0; i < count; ++i) {
    const auto* const endpoint = static_cast<const dds_builtintopic_endpoint_t*>(samples[static_cast<std::size_t>(i)]);
    if (!infos[static_cast<std::size_t>(i)].valid_data || !endpoint->topic_name || !endpoint->type_name) continue;
    const std::uint8_t* const guid = endpoint->participant_key.v;
    if (std::equal(guid, guid + sizeof own.v, own.v)) continue;
    others.push_back({endpoint->topic_name, endpoint->type_name, static_cast<std::uint16_t>((guid[0] << 8) | guid[1])});
  }
  if (count > 0) dds_return_loan(reader, samples.data(), count);
  return others;
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
