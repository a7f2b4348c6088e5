// SPDX-License-Identifier: Apache-2.0
// A program of ROS 2 as another maker's DDS would have it: reads or writes topics by Fast DDS, on loopback without multicast, and
// prints a JSON object a line.
//
// usage: fastdds_peer DOMAIN read TOPIC TYPE COUNT SECONDS [latched]
//        fastdds_peer DOMAIN write TOPIC TYPE COUNT HZ [latched]
//        fastdds_peer DOMAIN act ACTION plain|numbered 0 SECONDS JOINTS BEHAVIOUR       a controller (fastdds_controller.h)
//        fastdds_peer DOMAIN watch - - 0 SECONDS         the endpoints of others, with their USER_DATA
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <functional>
#include <string>
#include <thread>

#include "fastdds_controller.h"
#include "ros2_messagesPubSubTypes.h"

using namespace eprosima::fastdds::dds;
using eprosima::fastrtps::rtps::IPLocator;
using Clock = std::chrono::steady_clock;

namespace {

std::string json(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}
std::string json(const std::string& value) {
  std::string text = "\"";
  for (char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    if (c == '\n') {
      text += "\\n";
      continue;
    }
    text += c;
  }
  return text + "\"";
}
template <typename T>
std::string json(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? "," : "") + json(value);
  return text + "]";
}
std::string json(const std_msgs::msg::dds_::Header_& h) {
  return "{\"sec\":" + std::to_string(h.stamp().sec()) + ",\"nanosec\":" + std::to_string(h.stamp().nanosec()) +
         ",\"frame_id\":" + json(h.frame_id()) + "}";
}
template <typename V>
std::string xyz(const V& v) {
  return "[" + json(v.x()) + "," + json(v.y()) + "," + json(v.z()) + "]";
}
template <typename Q>
std::string wxyz(const Q& q) {
  return "[" + json(q.w()) + "," + json(q.x()) + "," + json(q.y()) + "," + json(q.z()) + "]";
}

std::string shown(const sensor_msgs::msg::dds_::JointState_& m) {
  return "{\"header\":" + json(m.header()) + ",\"name\":" + json(m.name()) + ",\"position\":" + json(m.position()) +
         ",\"velocity\":" + json(m.velocity()) + ",\"effort\":" + json(m.effort()) + "}";
}
std::string shown(const std_msgs::msg::dds_::String_& m) {
  return "{\"data\":" + json(m.data()) + "}";
}
std::string shown(const rosgraph_msgs::msg::dds_::Clock_& m) {
  return "{\"sec\":" + std::to_string(m.clock().sec()) + ",\"nanosec\":" + std::to_string(m.clock().nanosec()) + "}";
}
std::string shown(const geometry_msgs::msg::dds_::PoseStamped_& m) {
  return "{\"header\":" + json(m.header()) + ",\"position\":" + xyz(m.pose().position()) +
         ",\"orientation\":" + wxyz(m.pose().orientation()) + "}";
}
std::string shown(const geometry_msgs::msg::dds_::WrenchStamped_& m) {
  return "{\"header\":" + json(m.header()) + ",\"force\":" + xyz(m.wrench().force()) +
         ",\"torque\":" + xyz(m.wrench().torque()) + "}";
}
std::string shown(const tf2_msgs::msg::dds_::TFMessage_& m) {
  std::string text = "{\"transforms\":[";
  for (const auto& t : m.transforms()) {
    if (text.back() != '[') text += ",";
    text += "{\"header\":" + json(t.header()) + ",\"child\":" + json(t.child_frame_id()) +
            ",\"translation\":" + xyz(t.transform().translation()) + ",\"rotation\":" + wxyz(t.transform().rotation()) + "}";
  }
  return text + "]}";
}
std::string shown(const trajectory_msgs::msg::dds_::JointTrajectory_& m) {
  std::string text = "{\"joint_names\":" + json(m.joint_names()) + ",\"points\":[";
  for (const auto& p : m.points()) {
    if (text.back() != '[') text += ",";
    text += "{\"positions\":" + json(p.positions()) + ",\"velocities\":" + json(p.velocities()) +
            ",\"sec\":" + std::to_string(p.time_from_start().sec()) +
            ",\"nanosec\":" + std::to_string(p.time_from_start().nanosec()) + "}";
  }
  return text + "]}";
}
std::string shown(const moveit_msgs::msg::dds_::PlanningScene_& m) {
  std::string text = "{\"name\":" + json(m.name()) + ",\"robot\":" + json(m.robot_model_name()) +
                     ",\"is_diff\":" + std::to_string(m.is_diff()) + ",\"objects\":[";
  for (const auto& o : m.world().collision_objects()) {
    if (text.back() != '[') text += ",";
    const auto& mesh = o.meshes().at(0);
    text += "{\"id\":" + json(o.id()) + ",\"header\":" + json(o.header()) + ",\"position\":" + xyz(o.pose().position()) +
            ",\"orientation\":" + wxyz(o.pose().orientation()) + ",\"operation\":" + std::to_string(int(o.operation())) +
            ",\"triangles\":" + std::to_string(mesh.triangles().size()) +
            ",\"vertices\":" + std::to_string(mesh.vertices().size()) + ",\"first\":" + xyz(mesh.vertices().at(0)) +
            ",\"last_index\":" + std::to_string(mesh.triangles().back().vertex_indices()[2]) + "}";
  }
  return text + "]}";
}

std::string shown(const visualization_msgs::msg::dds_::MarkerArray_& m) {
  std::string text = "{\"markers\":[";
  for (const auto& k : m.markers()) {
    if (text.back() != '[') text += ",";
    const auto& c = k.color();
    text += "{\"header\":" + json(k.header()) + ",\"ns\":" + json(k.ns()) + ",\"id\":" + std::to_string(k.id()) +
            ",\"type\":" + std::to_string(k.type()) + ",\"action\":" + std::to_string(k.action()) +
            ",\"position\":" + xyz(k.pose().position()) + ",\"orientation\":" + wxyz(k.pose().orientation()) +
            ",\"scale\":" + xyz(k.scale()) + ",\"color\":" + json(std::vector<double>{c.r(), c.g(), c.b(), c.a()}) +
            ",\"lifetime\":" + json(k.lifetime().sec() + 1e-9 * k.lifetime().nanosec()) +
            ",\"frame_locked\":" + std::to_string(k.frame_locked()) +
            ",\"rest\":" + std::to_string(k.points().size() + k.colors().size() + k.uv_coordinates().size() +
                                          k.texture().data().size() + k.mesh_file().data().size() + k.text().size() +
                                          k.texture_resource().size() + k.mesh_resource().size() +
                                          k.mesh_use_embedded_materials()) + "}";
  }
  return text + "]}";
}

/// Says what endpoints of other participants announce.
class EndpointWatch : public DomainParticipantListener {
 public:
  void on_publisher_discovery(DomainParticipant*, eprosima::fastrtps::rtps::WriterDiscoveryInfo&& found) override {
    if (found.status == found.DISCOVERED_WRITER) say("writer", found.info);
  }
  void on_subscriber_discovery(DomainParticipant*, eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& found) override {
    if (found.status == found.DISCOVERED_READER) say("reader", found.info);
  }

 private:
  template <typename Endpoint>
  void say(const char* kind, const Endpoint& endpoint) {
    const auto& data = endpoint.m_qos.m_userData.getValue();
    std::printf("{\"kind\":\"%s\",\"topic\":%s,\"type\":%s,\"user_data\":%s}\n", kind,
                json(std::string(endpoint.topicName().c_str())).c_str(), json(std::string(endpoint.typeName().c_str())).c_str(),
                json(std::string(data.begin(), data.end())).c_str());
    std::fflush(stdout);
  }
};

DomainParticipant* participantOf(int domain) {
  DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
  auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  transport->interfaceWhiteList.push_back("127.0.0.1");
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(transport);
  auto& builtin = qos.wire_protocol().builtin;
  eprosima::fastrtps::rtps::Locator_t any(LOCATOR_KIND_UDPv4, 0);
  IPLocator::setIPv4(any, 127, 0, 0, 1);
  builtin.metatrafficUnicastLocatorList.push_back(any);
  for (int i = 0; i < 20; ++i) {
    eprosima::fastrtps::rtps::Locator_t peer(LOCATOR_KIND_UDPv4, 7400 + 250 * domain + 10 + 2 * i);
    IPLocator::setIPv4(peer, 127, 0, 0, 1);
    builtin.initialPeersList.push_back(peer);
  }
  return DomainParticipantFactory::get_instance()->create_participant(domain, qos);
}

template <typename Support>
int readTopic(DomainParticipant* participant, const std::string& topic, int count, double seconds, bool latched) {
  TypeSupport type(new Support());
  type.register_type(participant);
  Topic* const at = participant->create_topic(topic, type.get_type_name(), TOPIC_QOS_DEFAULT);
  DataReaderQos qos = DATAREADER_QOS_DEFAULT;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = latched ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1000;
  DataReader* const reader = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT)->create_datareader(at, qos);
  typename Support::type message;
  SampleInfo info;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  int got = 0;
  while (got < count && Clock::now() < end) {
    while (got < count && reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      ++got;
      std::printf("%s\n", shown(message).c_str());
    }
    std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return got == count ? 0 : 1;
}

template <typename Support, typename Fill>
int writeTopic(DomainParticipant* participant, const std::string& topic, int count, double hz, bool latched, Fill fill) {
  TypeSupport type(new Support());
  type.register_type(participant);
  Topic* const at = participant->create_topic(topic, type.get_type_name(), TOPIC_QOS_DEFAULT);
  DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = latched ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  DataWriter* const writer = participant->create_publisher(PUBLISHER_QOS_DEFAULT)->create_datawriter(at, qos);
  PublicationMatchedStatus status;
  for (int i = 0; i < 2000; ++i) {  // 20 s.
    writer->get_publication_matched_status(status);
    if (status.current_count > 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  auto due = Clock::now();
  for (int i = 0; i < count; ++i) {
    typename Support::type message;
    fill(i, message);
    writer->write(&message);
    due += std::chrono::nanoseconds(static_cast<long long>(1e9 / hz));
    std::this_thread::sleep_until(due);
  }
  writer->wait_for_acknowledgments({5, 0});
  std::printf("{\"written\":%d}\n", count);
  std::fflush(stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 7) return 2;
  DomainParticipant* const participant = participantOf(std::atoi(argv[1]));
  if (!participant) return 3;
  const std::string way = argv[2], topic = argv[3], type = argv[4];
  const int count = std::atoi(argv[5]);
  const double number = std::atof(argv[6]);
  const bool latched = argc > 7;
  int status = 2;
  static EndpointWatch watch;
  if (way == "watch") {
    participant->set_listener(&watch);
    std::this_thread::sleep_for(std::chrono::duration<double>(number));
    std::_Exit(0);
  }
  if (way == "act" && argc > 8) {
    status = playController(participant, topic, type, number, argv[7], argv[8]);
    std::_Exit(status);
  }
  if (way == "read") {
    if (type == "MarkerArray") status = readTopic<visualization_msgs::msg::dds_::MarkerArray_PubSubType>(participant, topic, count, number, latched);
    if (type == "JointState") status = readTopic<sensor_msgs::msg::dds_::JointState_PubSubType>(participant, topic, count, number, latched);
    if (type == "String") status = readTopic<std_msgs::msg::dds_::String_PubSubType>(participant, topic, count, number, latched);
    if (type == "Clock") status = readTopic<rosgraph_msgs::msg::dds_::Clock_PubSubType>(participant, topic, count, number, latched);
    if (type == "PoseStamped") status = readTopic<geometry_msgs::msg::dds_::PoseStamped_PubSubType>(participant, topic, count, number, latched);
    if (type == "WrenchStamped") status = readTopic<geometry_msgs::msg::dds_::WrenchStamped_PubSubType>(participant, topic, count, number, latched);
    if (type == "TFMessage") status = readTopic<tf2_msgs::msg::dds_::TFMessage_PubSubType>(participant, topic, count, number, latched);
    if (type == "JointTrajectory") status = readTopic<trajectory_msgs::msg::dds_::JointTrajectory_PubSubType>(participant, topic, count, number, latched);
    if (type == "PlanningScene") status = readTopic<moveit_msgs::msg::dds_::PlanningScene_PubSubType>(participant, topic, count, number, latched);
  } else if (type == "JointState") {
    status = writeTopic<sensor_msgs::msg::dds_::JointState_PubSubType>(
        participant, topic, count, number, latched, [&](int i, sensor_msgs::msg::dds_::JointState_& m) {
          const long long ns = 1'700'000'000'000'000'000LL + static_cast<long long>(1e9 / number) * i;
          m.header().stamp().sec(ns / 1'000'000'000);
          m.header().stamp().nanosec(ns % 1'000'000'000);
          m.name({"A1", "A2", "A3", "A4", "A5", "A6"});
          m.position({0.001 * i, -0.5, 0.25, 0.0, -0.001 * i, 1.0 / 3.0});
          m.velocity({1, 2, 3, 4, 5, 6});
        });
  } else if (type == "JointTrajectory") {
    status = writeTopic<trajectory_msgs::msg::dds_::JointTrajectory_PubSubType>(
        participant, topic, count, number, latched, [](int, trajectory_msgs::msg::dds_::JointTrajectory_& m) {
          m.joint_names({"a", "b"});
          for (int k = 0; k < 4; ++k) {
            trajectory_msgs::msg::dds_::JointTrajectoryPoint_ p;
            p.positions({0.5 * k, -1.0 * k});
            p.time_from_start().sec(k);
            p.time_from_start().nanosec(250'000'000);
            m.points().push_back(p);
          }
        });
  } else if (type == "PlanningScene") {
    status = writeTopic<moveit_msgs::msg::dds_::PlanningScene_PubSubType>(
        participant, topic, count, number, latched, [](int, moveit_msgs::msg::dds_::PlanningScene_& m) {
          m.is_diff(true);
          moveit_msgs::msg::dds_::CollisionObject_ crate;
          crate.id("crate");
          crate.header().frame_id("world");
          crate.pose().position().x(0.25);
          crate.pose().position().z(1.5);
          crate.pose().orientation().w(1.0);
          shape_msgs::msg::dds_::SolidPrimitive_ box;
          box.type(1);
          box.dimensions({0.5, 0.25, 2.0});
          crate.primitives().push_back(box);
          geometry_msgs::msg::dds_::Pose_ pose;
          pose.orientation().w(1.0);
          crate.primitive_poses().push_back(pose);
          m.world().collision_objects().push_back(crate);
        });
    std::this_thread::sleep_for(std::chrono::seconds(3));
  } else if (type == "String") {
    status = writeTopic<std_msgs::msg::dds_::String_PubSubType>(
        participant, topic, count, number, latched,
        [](int, std_msgs::msg::dds_::String_& m) { m.data("<robot name=\"r\"><link name=\"base\"/></robot>\n"); });
    std::this_thread::sleep_for(std::chrono::seconds(3));  // For who comes later.
  }
  std::_Exit(status);
}
