// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/recording_writer.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "exchange/mcap/mcap_writer.h"
#include "exchange/messages/ros_messages.h"
#include "exchange/recordings/recording_check.h"
#include "exchange/recordings/recording_topics.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::exchange {

namespace {

using nlohmann::ordered_json;
using trajectory::Trajectory;

/// s: 2^31 s of ROS's clock are enough for 68 years. Half, twice: no recording is near it.
constexpr double kLatestTime = 1e9;

ordered_json attemptJson(const trajectory::TrainingSession& session, const trajectory::TrainingAttempt& attempt) {
  const trajectory::TrainingScore& score = attempt.score;
  return {{"trainee", session.trainee},
          {"exercise", session.exercise},
          {"date", attempt.date},
          {"kind", wordOf(attempt.kind)},
          {"help", attempt.help},
          {"success", attempt.success},
          {"points", score.points},
          {"completed", score.completed},
          {"time", score.time},
          {"mean_deviation", score.mean_deviation},
          {"max_deviation", score.max_deviation},
          {"mean_force", score.mean_force},
          {"max_force", score.max_force},
          {"smoothness", score.smoothness},
          {"contacts", score.contacts}};
}

ordered_json touchJson(const Trajectory::Touch& touch) {
  return {{"first", touch.first},
          {"second", touch.second},
          {"time_in", touch.t_in},
          {"time_out", touch.t_out},
          {"max_force", touch.max_force}};
}

/// Collects messages of all topics and writes them by time.
class RecordingMessages {
 public:
  RecordingMessages(McapWriter& writer, std::int64_t zero) : writer_(writer), zero_(zero) {}

  /// Time of a moment of the recording in the file, ns.
  std::int64_t timeOf(double t) const { return topics::nanoseconds(t) + zero_; }

  template <typename Message>
  void addRos(std::string_view topic, std::string_view type, const Message& message, std::int64_t time) {
    add(topic, time, [&] { return std::pair(schema(type, "ros2msg", rosDefinition(type)), "cdr"); }, toCdr(message));
  }

  void addJson(std::string_view topic, std::string_view type, const char* schema_text, const ordered_json& message,
               double t) {
    add(topic, timeOf(t), [&] { return std::pair(schema(type, "jsonschema", schema_text), "json"); }, message.dump());
  }

  void write() {
    std::stable_sort(pending_.begin(), pending_.end(),
                     [](const Pending& a, const Pending& b) { return a.time < b.time; });
    for (const Pending& message : pending_)
      writer_.write(message.channel, static_cast<std::uint64_t>(message.time), message.data);
  }

 private:
  struct Pending {
    std::int64_t time;
    std::uint16_t channel;
    std::string data;
  };

  template <typename Declare>
  void add(std::string_view topic, std::int64_t time, const Declare& declare, std::string data) {
    auto known = channels_.find(topic);
    if (known == channels_.end()) {
      const std::pair<std::uint16_t, const char*> declared = declare();
      McapChannel channel{declared.first, std::string(topic), declared.second, {}};
      // What ros2 bag looks for: reliable, keep last 10, volatile.
      if (channel.message_encoding == "cdr") channel.metadata["offered_qos_profiles"] = "";
      known = channels_.emplace(topic, writer_.addChannel(std::move(channel))).first;
    }
    pending_.push_back({time, known->second, std::move(data)});
  }

  std::uint16_t schema(std::string_view name, std::string_view encoding, std::string_view text) {
    const auto known = schemas_.find(name);
    if (known != schemas_.end()) return known->second;
    const std::uint16_t id = writer_.addSchema({std::string(name), std::string(encoding), std::string(text)});
    return schemas_.emplace(name, id).first->second;
  }

  McapWriter& writer_;
  std::int64_t zero_;
  std::map<std::string, std::uint16_t, std::less<>> channels_, schemas_;
  std::vector<Pending> pending_;
};

/// force_x, force_y and force_z of a frame, if the recording has all three.
std::optional<dvec3> forceOf(const Trajectory& motion, std::size_t i) {
  const auto x = motion.findChannel("force_x"), y = motion.findChannel("force_y"), z = motion.findChannel("force_z");
  if (!x || !y || !z) return std::nullopt;
  const auto channels = motion.channels(i);
  return dvec3(channels[*x], channels[*y], channels[*z]);
}

void addFrame(RecordingMessages& messages, const Trajectory& motion, const std::string& prefix, std::size_t i) {
  const Trajectory::Frame& frame = motion[i];
  const std::int64_t time = messages.timeOf(frame.t);
  const RosHeader header{time, topics::kWorldFrame};
  if (motion.hasJoints()) {
    const auto joints = motion.joints(i);
    messages.addRos(prefix + std::string(topics::kJoints), "sensor_msgs/msg/JointState",
                    RosJointState{{time, ""}, motion.joint_names, {joints.begin(), joints.end()}, {}, {}}, time);
  }
  if (motion.has_poses) {
    messages.addRos(prefix + std::string(topics::kMoved), "geometry_msgs/msg/PoseStamped",
                    RosPoseStamped{header, frame.X_WT}, time);
    const std::string child = motion.entity.empty() ? "moved" : motion.entity;
    messages.addRos(topics::kTransforms, "tf2_msgs/msg/TFMessage", RosTransforms{{{header, child, frame.X_WT}}}, time);
  }
  if (const auto force = forceOf(motion, i)) {
    messages.addRos(prefix + std::string(topics::kWrench), "geometry_msgs/msg/WrenchStamped",
                    RosWrenchStamped{header, *force, dvec3(0.0)}, time);
  }
  if (!motion.channel_names.empty()) {
    ordered_json state;
    for (std::size_t k = 0; k < motion.channel_names.size(); ++k) state[motion.channel_names[k]] = motion.channels(i)[k];
    messages.addJson(prefix + std::string(topics::kState), "hapticell.State", topics::kStateSchema, state, frame.t);
  }
  if (frame.isSet() || frame.is_pose_apart) {
    ordered_json point{{"frame", i}, {"by_hand", frame.by_hand}, {"dwell", frame.dwell},
                       {"pose_apart", frame.is_pose_apart}};
    if (frame.name) point["name"] = *frame.name;
    messages.addJson(prefix + std::string(topics::kPoints), "hapticell.Point", topics::kPointSchema, point, frame.t);
  }
}

void addStylus(RecordingMessages& messages, const Recording& recording) {
  for (const StylusSample& sample : recording.stylus) {
    const std::int64_t time = messages.timeOf(sample.t);
    const RosHeader header{time, topics::kDeviceFrame};
    messages.addRos(topics::kStylus, "geometry_msgs/msg/PoseStamped", RosPoseStamped{header, sample.X_DS}, time);
    messages.addRos(topics::kProxy, "geometry_msgs/msg/PoseStamped", RosPoseStamped{header, sample.X_DP}, time);
    messages.addRos(topics::kForce, "geometry_msgs/msg/WrenchStamped",
                    RosWrenchStamped{header, sample.force_D, sample.torque_D}, time);
    RosJoy buttons{header, {sample.contact ? 1.0f : 0.0f}, {}};
    for (std::uint32_t bits = sample.buttons; bits != 0; bits >>= 1)
      buttons.buttons.push_back(static_cast<std::int32_t>(bits & 1u));
    messages.addRos(topics::kButtons, "sensor_msgs/msg/Joy", buttons, time);
    if (!recording.has_moved_frame) continue;
    messages.addRos(topics::kHeld, "geometry_msgs/msg/PoseStamped",
                    RosPoseStamped{{time, topics::kWorldFrame}, sample.X_WM}, time);
  }
}

std::string prefixOf(std::size_t motion) {
  return motion == 0 ? std::string() : "/motion_" + std::to_string(motion);
}

McapMetadata metadataOf(const Trajectory& motion, const std::string& prefix) {
  return {topics::kMotionMetadata,
          {{"prefix", prefix},
           {"name", motion.name},
           {"entity", motion.entity},
           {"moved", motion.moved},
           {"take", motion.take},
           {"joints", ordered_json(motion.joint_names).dump()},
           {"channels", ordered_json(motion.channel_names).dump()},
           {"has_poses", motion.has_poses ? "true" : "false"}}};
}

/// Whole nanoseconds added so that no time is below zero. Errors as mcapBytes().
Expected<std::int64_t> zeroOf(const Recording& recording) {
  double least = 0.0, most = 0.0;
  const auto take = [&](double t) {
    least = std::min(least, t);
    most = std::max(most, t);
  };
  for (const Trajectory& motion : recording.motions) {
    for (std::size_t i = 0; i < motion.size(); ++i) {
      take(motion[i].t);
      if (i > 0 && topics::nanoseconds(motion[i].t) <= topics::nanoseconds(motion[i - 1].t)) {
        return makeError({.place = Text("frame %1", i),
                          .found = "a time within the nanosecond of the frame before",
                          .expected = "frames at least a nanosecond apart"});
      }
    }
    for (const Trajectory::Touch& touch : motion.touches) take(touch.t_in);
  }
  for (const StylusSample& sample : recording.stylus) take(sample.t);
  for (const Trajectory::Touch& touch : recording.contacts) take(touch.t_in);
  if (!(least >= -kLatestTime) || !(most <= kLatestTime)) {
    return makeError({.place = "t", .found = "a time of more than 30 years", .expected = "seconds from the beginning"});
  }
  return static_cast<std::int64_t>(std::ceil(-least)) * 1'000'000'000;
}

}  // namespace

Expected<std::string> mcapBytes(const Recording& recording) {
  if (recording.isEmpty()) return makeError({.found = "an empty recording", .expected = "frames, samples or scores"});
  const auto zero = zeroOf(recording);
  HAPTICELL_TRY(zero);
  std::string bytes;
  McapWriterOptions options;
  options.profile = "ros2";
  McapWriter writer(
      [&bytes](std::string_view more) -> Expected<void> {
        bytes += more;
        return {};
      },
      options);
  writer.addMetadata({topics::kRecordingMetadata,
                      {{"version", "1"},
                       {"zero_ns", std::to_string(*zero)},
                       {"has_moved_frame", recording.has_moved_frame ? "true" : "false"}}});
  RecordingMessages messages(writer, *zero);
  for (std::size_t m = 0; m < recording.motions.size(); ++m) {
    const Trajectory& motion = recording.motions[m];
    writer.addMetadata(metadataOf(motion, prefixOf(m)));
    for (std::size_t i = 0; i < motion.size(); ++i) addFrame(messages, motion, prefixOf(m), i);
    for (const Trajectory::Touch& touch : motion.touches) {
      messages.addJson(prefixOf(m) + std::string(topics::kTouches), "hapticell.Contact", topics::kContactSchema,
                       touchJson(touch), touch.t_in);
    }
  }
  addStylus(messages, recording);
  for (const Trajectory::Touch& touch : recording.contacts)
    messages.addJson(topics::kContacts, "hapticell.Contact", topics::kContactSchema, touchJson(touch), touch.t_in);
  for (const trajectory::TrainingSession& session : recording.trainings) {
    for (std::size_t i = 0; i < session.attempts.size(); ++i) {  // A second apart: their own dates are in them.
      messages.addJson(topics::kScores, "hapticell.Score", topics::kScoreSchema,
                       attemptJson(session, session.attempts[i]), static_cast<double>(i));
    }
  }
  messages.write();
  for (const trajectory::TrainingSession& session : recording.trainings) {
    writer.addAttachment({0, 0, session.exercise + "-" + session.trainee + ".htrain", "application/json",
                          trajectory::toJsonText(session)});
  }
  for (const auto& [name, text] : recording.files) writer.addAttachment({0, 0, name, "application/json", text});
  HAPTICELL_TRY(writer.finish());
  return bytes;
}

Expected<void> writeMcapRecording(const Recording& recording, const std::filesystem::path& file) {
  const auto bytes = mcapBytes(recording);
  if (!bytes) {
    Error error = bytes.error();
    error.file = file.string();
    return tl::unexpected(error);
  }
  return writeFileChecked(file, *bytes, [&](const std::filesystem::path& written) -> Expected<void> {
    return checkRecording(recording, written);
  });
}

}  // namespace hapticell::exchange
