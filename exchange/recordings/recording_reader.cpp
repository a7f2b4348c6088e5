// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/recording_reader.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "exchange/messages/ros_messages.h"
#include "exchange/recordings/message_decoding.h"
#include "exchange/recordings/recording_topics.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"

namespace hapticell::exchange {

namespace {

using nlohmann::json;
using trajectory::Trajectory;

tl::unexpected<Error> badMetadata(const std::string& file, std::string_view what) {
  return makeError({file, Text("metadata '%1'", std::string(what)), "a value that this program does not write",
                    "a recording of HaptiCell, version 1", {}});
}

/// What is the same for all of a file of this program.
struct OwnFile {
  const McapContent& content;
  const TopicMessages& messages;
  std::int64_t zero = 0;

  double secondsOf(std::int64_t time) const { return static_cast<double>(time - zero) / 1e9; }
};

const McapMetadata* findMetadata(const McapContent& content, std::string_view name) {
  const auto found = std::find_if(content.metadata.begin(), content.metadata.end(),
                                  [&](const McapMetadata& metadata) { return metadata.name == name; });
  return found == content.metadata.end() ? nullptr : &*found;
}

std::string valueOf(const McapMetadata& metadata, const std::string& key) {
  const auto found = metadata.values.find(key);
  return found == metadata.values.end() ? std::string() : found->second;
}

Expected<std::vector<std::string>> namesOf(const McapMetadata& metadata, const std::string& key,
                                           const std::string& file) {
  const std::string text = valueOf(metadata, key);
  if (auto flat = geometry::checkNesting(text, geometry::NestedText::kJson, file); !flat)
    return tl::unexpected(flat.error());
  const json list = json::parse(text, nullptr, false);
  std::vector<std::string> names;
  if (!list.is_array()) return badMetadata(file, key);
  for (const json& name : list) {
    if (!name.is_string()) return badMetadata(file, key);
    names.push_back(name.get<std::string>());
  }
  return names;
}

Expected<Trajectory::Touch> touchOf(const OwnFile& own, std::string_view topic, std::size_t i) {
  const auto read = own.messages.json(topic, i);
  HAPTICELL_TRY(read);
  const auto number = [&](const char* key) { return read->value(key, json()); };
  const bool fits = number("time_in").is_number() && number("time_out").is_number() &&
                    number("max_force").is_number() && number("first").is_string() && number("second").is_string();
  if (!fits) return own.messages.undecodable(topic, i);
  return Trajectory::Touch{number("time_in").get<double>(), number("time_out").get<double>(),
                           number("first").get<std::string>(), number("second").get<std::string>(),
                           number("max_force").get<double>()};
}

Expected<std::vector<Trajectory::Touch>> touchesOf(const OwnFile& own, std::string_view topic) {
  std::vector<Trajectory::Touch> touches;
  for (std::size_t i = 0; i < own.messages.of(topic).size(); ++i) {
    auto touch = touchOf(own, topic, i);
    HAPTICELL_TRY(touch);
    touches.push_back(std::move(*touch));
  }
  return touches;
}

/// Frame numbers of a motion with what was set there.
Expected<std::map<std::size_t, json>> pointsOf(const OwnFile& own, const std::string& topic) {
  std::map<std::size_t, json> points;
  for (std::size_t i = 0; i < own.messages.of(topic).size(); ++i) {
    auto read = own.messages.json(topic, i);
    HAPTICELL_TRY(read);
    const json frame = read->value("frame", json());
    const bool fits = frame.is_number_unsigned() && read->value("by_hand", json()).is_boolean() &&
                      read->value("dwell", json()).is_number() && read->value("pose_apart", json()).is_boolean() &&
                      read->value("name", json("")).is_string();
    if (!fits) return own.messages.undecodable(topic, i);
    points[frame.get<std::size_t>()] = std::move(*read);
  }
  return points;
}

/// The frames of one motion, topic by topic: message i of each belongs to frame i.
struct MotionTopics {
  std::string joints, poses, state;
  std::size_t frames = 0;
};

Expected<void> addOwnFrame(const OwnFile& own, const MotionTopics& topics, std::size_t i, const json* point,
                           Trajectory& motion) {
  Trajectory::Frame frame;
  std::vector<double> joints, channels;
  std::int64_t time = 0;
  if (motion.hasJoints()) {
    const auto read = jointStateFromCdr(own.messages.of(topics.joints)[i]->data);
    if (!read || read->name != motion.joint_names || read->position.size() != read->name.size())
      return own.messages.undecodable(topics.joints, i);
    joints = read->position;
    time = read->header.stamp_ns;
  }
  if (motion.has_poses) {
    const auto read = poseStampedFromCdr(own.messages.of(topics.poses)[i]->data);
    const auto pose = read ? usablePose(read->pose) : std::nullopt;
    if (!pose) return own.messages.undecodable(topics.poses, i);
    frame.X_WT = *pose;
    time = read->header.stamp_ns;
  }
  if (!motion.channel_names.empty()) {
    const auto state = own.messages.json(topics.state, i);
    HAPTICELL_TRY(state);
    for (const std::string& name : motion.channel_names) {
      const json value = state->value(name, json());
      if (!value.is_number()) return own.messages.undecodable(topics.state, i);
      channels.push_back(value.get<double>());
    }
  }
  frame.t = own.secondsOf(time);
  if (point) {
    frame.by_hand = (*point)["by_hand"].get<bool>();
    frame.dwell = (*point)["dwell"].get<double>();
    frame.is_pose_apart = (*point)["pose_apart"].get<bool>();
    if (point->contains("name")) frame.name = std::make_shared<const std::string>((*point)["name"].get<std::string>());
  }
  const std::string& topic = motion.hasJoints() ? topics.joints : topics.poses;
  const bool finite = std::all_of(joints.begin(), joints.end(), [](double q) { return std::isfinite(q); });
  if (!finite || !motion.addFrame(frame, joints, channels))
    return own.messages.undecodable(topic, i, "a time that does not rise, or a number that is not finite",
                                    "frames in the order of time");
  return {};
}

Expected<Trajectory> ownMotion(const OwnFile& own, const McapMetadata& head) {
  const std::string& file = own.messages.fileName();
  const std::string prefix = valueOf(head, "prefix");
  Trajectory motion;
  motion.name = valueOf(head, "name");
  motion.entity = valueOf(head, "entity");
  motion.moved = valueOf(head, "moved");
  motion.take = valueOf(head, "take");
  motion.has_poses = valueOf(head, "has_poses") == "true";
  auto joints = namesOf(head, "joints", file), channels = namesOf(head, "channels", file);
  HAPTICELL_TRY(joints);
  HAPTICELL_TRY(channels);
  motion.joint_names = std::move(*joints);
  motion.channel_names = std::move(*channels);
  if (!motion.has_poses && !motion.hasJoints()) return badMetadata(file, "has_poses");
  if (!std::all_of(motion.channel_names.begin(), motion.channel_names.end(), trajectory::isChannel))
    return badMetadata(file, "channels");
  MotionTopics names{prefix + std::string(topics::kJoints), prefix + std::string(topics::kMoved),
                     prefix + std::string(topics::kState), 0};
  names.frames = own.messages.of(motion.hasJoints() ? names.joints : names.poses).size();
  const bool fits = (!motion.has_poses || own.messages.of(names.poses).size() == names.frames) &&
                    (motion.channel_names.empty() || own.messages.of(names.state).size() == names.frames);
  if (!fits)
    return makeError({file, Text("motion '%1'", motion.name), "topics with different numbers of messages",
                      "one message for each frame", {}});
  const auto points = pointsOf(own, prefix + std::string(topics::kPoints));
  HAPTICELL_TRY(points);
  motion.reserve(names.frames);
  for (std::size_t i = 0; i < names.frames; ++i) {
    const auto point = points->find(i);
    HAPTICELL_TRY(addOwnFrame(own, names, i, point == points->end() ? nullptr : &point->second, motion));
  }
  auto touches = touchesOf(own, prefix + std::string(topics::kTouches));
  HAPTICELL_TRY(touches);
  motion.touches = std::move(*touches);
  return motion;
}

Expected<StylusSample> sampleOf(const OwnFile& own, std::size_t i, bool has_moved_frame) {
  const auto at = [&](std::string_view topic) -> const std::string& { return own.messages.of(topic)[i]->data; };
  const auto pose = poseStampedFromCdr(at(topics::kStylus)), proxy = poseStampedFromCdr(at(topics::kProxy));
  const auto wrench = wrenchStampedFromCdr(at(topics::kForce));
  const auto joy = joyFromCdr(at(topics::kButtons));
  const auto moved = has_moved_frame ? poseStampedFromCdr(at(topics::kHeld)) : RosPoseStamped{};
  if (!pose || !proxy || !wrench || !joy || !moved || joy->axes.size() != 1 || joy->buttons.size() > 32)
    return own.messages.undecodable(topics::kStylus, i);
  const auto X_DS = usablePose(pose->pose), X_DP = usablePose(proxy->pose), X_WM = usablePose(moved->pose);
  if (!X_DS || !X_DP || !X_WM) return own.messages.undecodable(topics::kStylus, i);
  StylusSample sample{own.secondsOf(pose->header.stamp_ns), *X_DS, *X_DP, wrench->force, wrench->torque, 0,
                      joy->axes.front() != 0.0f, *X_WM};
  for (std::size_t bit = 0; bit < joy->buttons.size(); ++bit)
    if (joy->buttons[bit] != 0) sample.buttons |= std::uint32_t{1} << bit;
  return sample;
}

Expected<void> readStylus(const OwnFile& own, Recording& recording) {
  const std::size_t count = own.messages.of(topics::kStylus).size();
  bool fits = true;
  for (const std::string_view topic : {topics::kProxy, topics::kForce, topics::kButtons})
    fits = fits && own.messages.of(topic).size() == count;
  if (recording.has_moved_frame) fits = fits && own.messages.of(topics::kHeld).size() == count;
  if (!fits)
    return makeError({own.messages.fileName(), "stylus", "topics with different numbers of messages",
                      "one message for each sample", {}});
  recording.stylus.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto sample = sampleOf(own, i, recording.has_moved_frame);
    HAPTICELL_TRY(sample);
    if (!recording.stylus.empty() && !(sample->t > recording.stylus.back().t))
      return own.messages.undecodable(topics::kStylus, i, "a time that does not rise", "samples in the order of time");
    recording.stylus.push_back(*sample);
  }
  return {};
}

Expected<void> readAttachments(const OwnFile& own, Recording& recording) {
  for (const McapAttachment& attachment : own.content.attachments) {
    if (lowerExtension(attachment.name) != ".htrain") {
      recording.files.emplace_back(attachment.name, attachment.data);
      continue;
    }
    auto session = trajectory::parseTraining(attachment.data, own.messages.fileName());
    HAPTICELL_TRY(session);
    recording.trainings.push_back(std::move(*session));
  }
  return {};
}

Expected<Recording> ownRecording(const McapContent& content, const TopicMessages& messages, const McapMetadata& head) {
  OwnFile own{content, messages, 0};
  const std::string zero = valueOf(head, "zero_ns");
  char* end = nullptr;
  own.zero = std::strtoll(zero.c_str(), &end, 10);
  if (zero.empty() || *end != '\0' || own.zero < 0 || own.zero > 2'000'000'000'000'000'000)
    return badMetadata(messages.fileName(), "zero_ns");
  if (valueOf(head, "version") != "1") {
    return makeError({messages.fileName(), Text("metadata '%1'", "version"),
                      Text("version %1", valueOf(head, "version")), "version 1", "Update HaptiCell."});
  }
  Recording recording;
  recording.has_moved_frame = valueOf(head, "has_moved_frame") == "true";
  for (const McapMetadata& metadata : content.metadata) {
    if (metadata.name != topics::kMotionMetadata) continue;
    auto motion = ownMotion(own, metadata);
    HAPTICELL_TRY(motion);
    recording.motions.push_back(std::move(*motion));
  }
  HAPTICELL_TRY(readStylus(own, recording));
  auto contacts = touchesOf(own, topics::kContacts);
  HAPTICELL_TRY(contacts);
  recording.contacts = std::move(*contacts);
  HAPTICELL_TRY(readAttachments(own, recording));
  return recording;
}

}  // namespace

Expected<Recording> parseMcapRecording(std::string_view bytes, const std::string& name, const std::string& topic) {
  const auto content = readMcap(bytes, name);
  HAPTICELL_TRY(content);
  const TopicMessages messages(*content, name);
  const McapMetadata* const head = findMetadata(*content, topics::kRecordingMetadata);
  if (head && topic.empty()) return ownRecording(*content, messages, *head);
  Recording recording;
  auto motion = foreignMotion(messages, topic, recording.notes);
  HAPTICELL_TRY(motion);
  motion->name = std::filesystem::path(name).stem().string();
  recording.motions.push_back(std::move(*motion));
  return recording;
}

Expected<Recording> readMcapRecording(const std::filesystem::path& file, const std::string& topic) {
  const auto bytes = geometry::readRegularFile(file);
  HAPTICELL_TRY(bytes);
  return parseMcapRecording(*bytes, file.string(), topic);
}

namespace {

/// Of the file `file`, which has no other motion.
Expected<Trajectory> stylusMotion(const Recording& recording, const std::filesystem::path& file,
                                  std::vector<Text>& notes) {
  if (recording.stylus.empty())
    return makeError({file.string(), "topics", "no motion", "poses or joints of something that moved", {}});
  notes.push_back("the file has no motion of an entity; that of the stylus is read");
  Trajectory motion;
  motion.name = file.stem().string();
  motion.channel_names = {"force_x", "force_y", "force_z", "contact"};
  for (const StylusSample& sample : recording.stylus) {
    const double channels[] = {sample.force_D.x, sample.force_D.y, sample.force_D.z, sample.contact ? 1.0 : 0.0};
    motion.addFrame({sample.t, sample.X_DS}, {}, channels);
  }
  return motion;
}

/// What the recording has beside its motions.
void noteTheRest(const Recording& recording, std::vector<Text>& notes) {
  if (!recording.motions.empty() && !recording.stylus.empty())
    notes.push_back(Text("samples of the stylus, not read: %1", recording.stylus.size()));
  if (!recording.contacts.empty())
    notes.push_back(Text("contacts of the session, not read: %1", recording.contacts.size()));
  if (!recording.trainings.empty())
    notes.push_back(Text("results of training, not read: %1", recording.trainings.size()));
  for (const auto& [name, content] : recording.files) notes.push_back(Text("attachment, not read: %1", name));
}

}  // namespace

Expected<Trajectory> readMcapMotion(const std::filesystem::path& file, const std::string& topic,
                                    std::vector<Text>* notes) {
  auto recording = readMcapRecording(file, topic);
  HAPTICELL_TRY(recording);
  std::vector<Text> unheard;
  std::vector<Text>& into = notes ? *notes : unheard;
  into.insert(into.end(), recording->notes.begin(), recording->notes.end());
  if (recording->motions.empty()) return stylusMotion(*recording, file, into);
  if (recording->motions.size() > 1)
    into.push_back(Text("motions in the file, of which the first is read: %1", recording->motions.size()));
  return std::move(recording->motions.front());
}

Expected<McapMotions> readMcapMotions(const std::filesystem::path& file, std::vector<Text>& notes) {
  auto recording = readMcapRecording(file);
  HAPTICELL_TRY(recording);
  notes.insert(notes.end(), recording->notes.begin(), recording->notes.end());
  McapMotions read;
  read.is_stylus = recording->motions.empty();
  if (read.is_stylus) {
    auto motion = stylusMotion(*recording, file, notes);
    HAPTICELL_TRY(motion);
    read.motions.push_back(std::move(*motion));
  }
  noteTheRest(*recording, notes);
  if (!read.is_stylus) read.motions = std::move(recording->motions);
  return read;
}

bool isMcapFile(const std::filesystem::path& file) {
  return lowerExtension(file) == ".mcap";
}

}  // namespace hapticell::exchange
