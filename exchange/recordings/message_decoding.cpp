// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/message_decoding.h"

#include <algorithm>
#include <cmath>

#include "exchange/messages/ros_messages.h"
#include "exchange/recordings/recording_topics.h"
#include "geometry/system/listed.h"
#include "geometry/system/nesting_limit.h"

namespace hapticell::exchange {

namespace {

using trajectory::Trajectory;

constexpr std::string_view kJointStates = "sensor_msgs/msg/JointState", kPoses = "geometry_msgs/msg/PoseStamped";
// Of a quaternion's length; as kUnitTolerance of trajectory/files/pose_csv.cpp, where half and twice are given.
constexpr double kUnitLengthTolerance = 1e-3;

/// The stamp of the message, or its log time where it has none.
std::int64_t timeOf(const RosHeader& header, const McapMessage& message) {
  return header.stamp_ns != 0 ? header.stamp_ns : static_cast<std::int64_t>(message.log_time & ~(std::uint64_t{1} << 63));
}

/// The topic of a type that is read: `asked`, one that is `usual`, or the only one. Empty: there is none.
Expected<std::string> chosenTopic(const TopicMessages& messages, std::string_view type, const std::string& asked,
                                  std::initializer_list<std::string_view> usual) {
  const std::vector<std::string> topics = messages.ofType(type);
  if (!asked.empty()) return std::find(topics.begin(), topics.end(), asked) != topics.end() ? asked : std::string();
  for (const std::string_view name : usual)
    if (std::find(topics.begin(), topics.end(), name) != topics.end()) return std::string(name);
  if (topics.size() < 2) return topics.empty() ? std::string() : topics.front();
  return makeError({messages.fileName(), "topics",
                    Text("several of type %1: %2", std::string(type), listed(topics, [](const auto& t) { return t; })),
                    "one topic", "Choose one with 'hapticell-cli record --from FILE --topic TOPIC'."});
}

struct TimedPose {
  std::int64_t time;
  Pose pose;
};

Expected<std::vector<TimedPose>> posesOf(const TopicMessages& messages, const std::string& topic) {
  std::vector<TimedPose> poses;
  const auto& all = messages.of(topic);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto read = poseStampedFromCdr(all[i]->data);
    if (!read) return messages.undecodable(topic, i);
    const auto pose = usablePose(read->pose);
    if (!pose) return messages.undecodable(topic, i, "no pose", "finite numbers and a unit quaternion");
    poses.push_back({timeOf(read->header, *all[i]), *pose});
  }
  return poses;
}

/// What a motion leaves out of a topic.
struct LeftOut {
  std::size_t other_joints = 0, late = 0;
  void note(const std::string& topic, std::vector<Text>& notes) const {
    if (other_joints > 0) notes.push_back(Text("%1: %2 messages of other joints are left out", topic, other_joints));
    if (late > 0) notes.push_back(Text("%1: %2 messages whose time does not rise are left out", topic, late));
  }
};

Expected<Trajectory> motionOfPoses(const TopicMessages& messages, const std::string& topic, std::vector<Text>& notes) {
  const auto poses = posesOf(messages, topic);
  HAPTICELL_TRY(poses);
  Trajectory motion;
  LeftOut left_out;
  for (const TimedPose& at : *poses) {
    const double t = 1e-9 * static_cast<double>(at.time - poses->front().time);
    if (!motion.addFrame({t, at.pose})) ++left_out.late;
  }
  left_out.note(topic, notes);
  return motion;
}

Expected<Trajectory> motionOfJoints(const TopicMessages& messages, const std::string& topic,
                                    const std::vector<TimedPose>& poses, std::vector<Text>& notes) {
  Trajectory motion;
  LeftOut left_out;
  const auto& all = messages.of(topic);
  std::int64_t start = 0;
  std::map<std::int64_t, Pose> pose_at;
  for (const TimedPose& pose : poses) pose_at.emplace(pose.time, pose.pose);
  std::vector<std::pair<std::int64_t, std::vector<double>>> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto read = jointStateFromCdr(all[i]->data);
    if (!read || read->position.size() != read->name.size()) {
      if (read && read->position.empty()) continue;  // Velocities or efforts alone.
      return messages.undecodable(topic, i);
    }
    if (!std::all_of(read->position.begin(), read->position.end(), [](double q) { return std::isfinite(q); }))
      return messages.undecodable(topic, i, "a number that is not finite", "joint positions");
    if (rows.empty()) {
      motion.joint_names = read->name;
      start = timeOf(read->header, *all[i]);
    }
    if (read->name != motion.joint_names) {
      ++left_out.other_joints;
      continue;
    }
    rows.emplace_back(timeOf(read->header, *all[i]), read->position);
  }
  motion.has_poses = !rows.empty() && std::all_of(rows.begin(), rows.end(),
                                                  [&](const auto& row) { return pose_at.contains(row.first); });
  for (const auto& [time, joints] : rows) {
    const Pose pose = motion.has_poses ? pose_at.at(time) : Pose::identity();
    if (!motion.addFrame({1e-9 * static_cast<double>(time - start), pose}, joints)) ++left_out.late;
  }
  left_out.note(topic, notes);
  return motion;
}

}  // namespace

TopicMessages::TopicMessages(const McapContent& content, std::string name)
    : content_(content), name_(std::move(name)) {
  for (const McapMessage& message : content.messages)
    topics_[content.channels.at(message.channel).topic].push_back(&message);
}

const std::vector<const McapMessage*>& TopicMessages::of(std::string_view topic) const {
  static const std::vector<const McapMessage*> kNone;
  const auto found = topics_.find(topic);
  return found == topics_.end() ? kNone : found->second;
}

std::vector<std::string> TopicMessages::ofType(std::string_view type) const {
  std::vector<std::string> found;
  for (const auto& [topic, messages] : topics_) {
    const McapChannel& channel = content_.channels.at(messages.front()->channel);
    const auto schema = content_.schemas.find(channel.schema);
    const bool fits = channel.message_encoding == "cdr" && schema != content_.schemas.end() && schema->second.name == type;
    if (fits) found.push_back(topic);
  }
  return found;
}

tl::unexpected<Error> TopicMessages::undecodable(std::string_view topic, std::size_t i, Text found,
                                                 Text expected) const {
  return makeError({name_, Text("topic %1, message %2", std::string(topic), i), std::move(found), std::move(expected), {}});
}

Expected<nlohmann::json> TopicMessages::json(std::string_view topic, std::size_t i) const {
  const std::string& text = of(topic)[i]->data;
  if (auto flat = geometry::checkNesting(text, geometry::NestedText::kJson, name_); !flat)
    return tl::unexpected(flat.error());
  nlohmann::json read = nlohmann::json::parse(text, nullptr, false);
  if (read.is_discarded() || !read.is_object()) return undecodable(topic, i);
  return read;
}

std::optional<Pose> usablePose(const Pose& pose) {
  const double norm = glm::length(pose.q);
  const bool is_finite = std::isfinite(pose.p.x) && std::isfinite(pose.p.y) && std::isfinite(pose.p.z);
  if (!is_finite || !(std::abs(norm - 1.0) <= kUnitLengthTolerance)) return std::nullopt;
  return Pose{pose.p, std::abs(norm - 1.0) < 1e-9 ? pose.q : pose.q / norm};
}

Expected<Trajectory> foreignMotion(const TopicMessages& messages, const std::string& topic, std::vector<Text>& notes) {
  const auto joints = chosenTopic(messages, kJointStates, topic, {topics::kJoints});
  HAPTICELL_TRY(joints);
  const auto pose = chosenTopic(messages, kPoses, topic, {topics::kMoved, topics::kHeld, topics::kStylus});
  // With joints, poses are welcome but nobody has to choose among several.
  if (!pose && joints->empty()) return tl::unexpected(pose.error());
  if (joints->empty() && pose->empty()) {
    return makeError({messages.fileName(), topic.empty() ? Text("topics") : Text("topic %1", topic), "none that can be read",
                      "messages of sensor_msgs/msg/JointState or geometry_msgs/msg/PoseStamped in CDR", {}});
  }
  if (joints->empty()) return motionOfPoses(messages, *pose, notes);
  const auto poses = pose && !pose->empty() ? posesOf(messages, *pose) : Expected<std::vector<TimedPose>>();
  HAPTICELL_TRY(poses);
  return motionOfJoints(messages, *joints, *poses, notes);
}

}  // namespace hapticell::exchange
