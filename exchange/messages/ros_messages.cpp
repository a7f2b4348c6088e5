// SPDX-License-Identifier: Apache-2.0
#include "exchange/messages/ros_messages.h"

#include <algorithm>
#include <array>

#include "exchange/messages/cdr.h"
#include "geometry/system/assertion.h"

namespace hapticell::exchange {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

void add(CdrWriter& cdr, const RosHeader& header) {
  cdr.add(static_cast<std::int32_t>(header.stamp_ns / kNanosecondsPerSecond));
  cdr.add(static_cast<std::uint32_t>(header.stamp_ns % kNanosecondsPerSecond));
  cdr.add(std::string_view(header.frame_id));
}

void add(CdrWriter& cdr, const dvec3& v) {
  for (int i = 0; i < 3; ++i) cdr.add(v[i]);
}

void add(CdrWriter& cdr, const Pose& pose) {
  add(cdr, pose.p);
  for (const double value : {pose.q.x, pose.q.y, pose.q.z, pose.q.w}) cdr.add(value);
}

RosHeader header(CdrReader& cdr) {
  RosHeader read;
  read.stamp_ns = cdr.int32() * kNanosecondsPerSecond;
  read.stamp_ns += cdr.uint32();
  read.frame_id = cdr.text();
  return read;
}

dvec3 vector(CdrReader& cdr) {
  dvec3 v;
  for (int i = 0; i < 3; ++i) v[i] = cdr.float64();
  return v;
}

Pose pose(CdrReader& cdr) {
  Pose read;
  read.p = vector(cdr);
  const double x = cdr.float64(), y = cdr.float64(), z = cdr.float64(), w = cdr.float64();
  read.q = dquat(w, x, y, z);
  return read;
}

template <typename Message>
std::optional<Message> whole(const CdrReader& cdr, Message message) {
  if (!cdr.isGood()) return std::nullopt;
  return message;
}

struct Definition {
  std::string_view type;    ///< Without "/msg/", as definitions name others.
  std::string_view fields;  ///< As in the public file, without its comments.
  std::array<std::string_view, 5> uses{};
};

constexpr std::string_view kTime = "builtin_interfaces/Time", kHeader = "std_msgs/Header",
                           kVector = "geometry_msgs/Vector3", kQuaternion = "geometry_msgs/Quaternion";

const Definition& definitionOf(std::string_view type) {
  static const Definition kDefinitions[] = {
      {kTime, "int32 sec\nuint32 nanosec\n"},
      {kHeader, "builtin_interfaces/Time stamp\nstring frame_id\n", {kTime}},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {kVector, "float64 x\nfloat64 y\nfloat64 z\n"},
      {kQuaternion, "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
      {"geometry_msgs/Pose", "Point position\nQuaternion orientation\n", {"geometry_msgs/Point", kQuaternion}},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\nPose pose\n", {kHeader, "geometry_msgs/Pose"}},
      {"geometry_msgs/Wrench", "Vector3  force\nVector3  torque\n", {kVector}},
      {"geometry_msgs/WrenchStamped", "std_msgs/Header header\nWrench wrench\n", {kHeader, "geometry_msgs/Wrench"}},
      {"geometry_msgs/Transform", "Vector3 translation\nQuaternion rotation\n", {kVector, kQuaternion}},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\nTransform transform\n",
       {kHeader, "geometry_msgs/Transform"}},
      {"tf2_msgs/TFMessage",
       "geometry_msgs/TransformStamped[] transforms\n",
       {"geometry_msgs/TransformStamped"}},
      {"sensor_msgs/JointState",
       "std_msgs/Header header\n\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n",
       {kHeader}},
      {"sensor_msgs/Joy", "std_msgs/Header header\nfloat32[] axes\nint32[] buttons\n", {kHeader}},
  };
  const auto* const found = std::find_if(std::begin(kDefinitions), std::end(kDefinitions),
                                         [&](const Definition& definition) { return definition.type == type; });
  HAPTICELL_DEMAND(found != std::end(kDefinitions));
  return *found;
}

void collectUses(const Definition& definition, std::vector<std::string_view>& into) {
  for (const std::string_view used : definition.uses) {
    if (used.empty() || std::find(into.begin(), into.end(), used) != into.end()) continue;
    into.push_back(used);
    collectUses(definitionOf(used), into);
  }
}

}  // namespace

std::string toCdr(const RosJointState& message) {
  CdrWriter cdr;
  add(cdr, message.header);
  cdr.add(std::span<const std::string>(message.name));
  for (const auto* values : {&message.position, &message.velocity, &message.effort})
    cdr.add(std::span<const double>(*values));
  return cdr.take();
}

std::string toCdr(const RosPoseStamped& message) {
  CdrWriter cdr;
  add(cdr, message.header);
  add(cdr, message.pose);
  return cdr.take();
}

std::string toCdr(const RosWrenchStamped& message) {
  CdrWriter cdr;
  add(cdr, message.header);
  add(cdr, message.force);
  add(cdr, message.torque);
  return cdr.take();
}

std::string toCdr(const RosTransforms& message) {
  CdrWriter cdr;
  cdr.addCount(message.transforms.size());
  for (const RosTransformStamped& transform : message.transforms) {
    add(cdr, transform.header);
    cdr.add(std::string_view(transform.child_frame_id));
    add(cdr, transform.transform);
  }
  return cdr.take();
}

std::string toCdr(const RosJoy& message) {
  CdrWriter cdr;
  add(cdr, message.header);
  cdr.add(std::span<const float>(message.axes));
  cdr.add(std::span<const std::int32_t>(message.buttons));
  return cdr.take();
}

std::optional<RosJointState> jointStateFromCdr(std::string_view bytes) {
  CdrReader cdr(bytes);
  RosJointState message;
  message.header = header(cdr);
  message.name = cdr.texts();
  message.position = cdr.doubles();
  message.velocity = cdr.doubles();
  message.effort = cdr.doubles();
  return whole(cdr, std::move(message));
}

std::optional<RosPoseStamped> poseStampedFromCdr(std::string_view bytes) {
  CdrReader cdr(bytes);
  RosPoseStamped message;
  message.header = header(cdr);
  message.pose = pose(cdr);
  return whole(cdr, std::move(message));
}

std::optional<RosWrenchStamped> wrenchStampedFromCdr(std::string_view bytes) {
  CdrReader cdr(bytes);
  RosWrenchStamped message;
  message.header = header(cdr);
  message.force = vector(cdr);
  message.torque = vector(cdr);
  return whole(cdr, std::move(message));
}

std::optional<RosTransforms> transformsFromCdr(std::string_view bytes) {
  CdrReader cdr(bytes);
  RosTransforms message;
  const std::size_t count = cdr.count(72);
  for (std::size_t i = 0; i < count && cdr.isGood(); ++i) {
    RosTransformStamped transform;
    transform.header = header(cdr);
    transform.child_frame_id = cdr.text();
    transform.transform = pose(cdr);
    message.transforms.push_back(std::move(transform));
  }
  return whole(cdr, std::move(message));
}

std::optional<RosJoy> joyFromCdr(std::string_view bytes) {
  CdrReader cdr(bytes);
  RosJoy message;
  message.header = header(cdr);
  message.axes = cdr.floats();
  message.buttons = cdr.ints();
  return whole(cdr, std::move(message));
}

std::string rosDefinition(std::string_view type) {
  std::string name(type);
  if (const std::size_t at = name.find("/msg/"); at != std::string::npos) name.erase(at, 4);
  const Definition& definition = definitionOf(name);
  std::vector<std::string_view> uses;
  collectUses(definition, uses);
  std::string text(definition.fields);
  for (const std::string_view used : uses) {
    text += std::string(80, '=') + "\nMSG: ";
    text += used;
    text += '\n';
    text += definitionOf(used).fields;
  }
  return text;
}

}  // namespace hapticell::exchange
