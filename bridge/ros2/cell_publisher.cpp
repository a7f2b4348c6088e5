// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/cell_publisher.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

#include "bridge/ros2/contact_markers.h"
#include "bridge/ros2/ros_conversion.h"
#include "exchange/recordings/recording_reader.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/scratch_folder.h"
#include "haptic/client/server_watch.h"
#include "kinematics/model/robot_model.h"
#include "manipulation/checks/motion_replay.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"
#include "workcell/robots/urdf_writer.h"

namespace hapticell::bridge {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using manipulation::EntityConfiguration;
using nlohmann::ordered_json;
using workcell::Entity;

constexpr const char* kWorldFrame = "world";
constexpr const char* kDeviceFrame = "device";

/// A topic with its writer and how often it was written.
struct Topic {
  dds_entity_t writer = 0;
  std::string name;
  std::uint64_t count = 0;
};

/// The robot's URDF with meshes as file:// addresses, so that every program of this machine finds them.
Expected<std::string> robotDescription(const Entity& robot, const fs::path& folder, Diagnostics& notes) {
  const fs::path file = fs::absolute(folder) / "robot.urdf";
  HAPTICELL_TRY(workcell::writeUrdf(robot, file, notes));
  auto text = geometry::readRegularFile(file);
  HAPTICELL_TRY(text);
  const std::string relative = "filename=\"robot_meshes/", whole = "filename=\"file://" + file.parent_path().string() + "/robot_meshes/";
  for (std::size_t at = text->find(relative); at != std::string::npos; at = text->find(relative, at + whole.size()))
    text->replace(at, relative.size(), whole);
  return text;
}

Expected<std::shared_ptr<const Entity>> robotOf(const workcell::Document& document, const PublishOptions& options) {
  std::shared_ptr<const Entity> found;
  std::string names;
  for (const auto& entity : document.state().entities) {
    if (!workcell::isMachine(*entity)) continue;
    if (!options.entity.empty() && entity->name == options.entity) return entity;
    names += (names.empty() ? "" : ", ") + entity->name;
    found = found ? nullptr : entity;
    if (!found) break;
  }
  if (options.entity.empty() && found) return found;
  return makeError({options.workcell, options.entity.empty() ? Text("robots") : Text("entity '%1'", options.entity),
                    names.empty() ? Text("no robot") : Text("the robots %1", names), "one robot", "Name it by --entity."});
}

/// Link poses as tf has them: each link in its parent link.
class RobotFrames {
 public:
  explicit RobotFrames(const kinematics::RobotModel& model) : model_(model) {}

  /// Transforms of fixed joints (`moving` false) or of the others.
  std::vector<geometry_msgs_msg_dds__TransformStamped_> at(const std::vector<double>& q, bool moving,
                                                           std::int64_t stamp_ns) {
    kinematics::forwardKinematics(model_, q, X_BL_);
    std::vector<geometry_msgs_msg_dds__TransformStamped_> transforms;
    for (const kinematics::Joint& joint : model_.joints) {
      const bool is_fixed = joint.type == kinematics::JointType::kFixed && !model_.closure;
      if (is_fixed == moving) continue;
      const auto parent = static_cast<std::size_t>(joint.parent_link), child = static_cast<std::size_t>(joint.child_link);
      transforms.push_back(rosTransform(stamp_ns, model_.links[parent].name, model_.links[child].name,
                                        X_BL_[parent].inverse() * X_BL_[child]));
    }
    return transforms;
  }

 private:
  const kinematics::RobotModel& model_;
  std::vector<Pose> X_BL_;
};

tf2_msgs_msg_dds__TFMessage_ messageOf(std::vector<geometry_msgs_msg_dds__TransformStamped_>& transforms) {
  tf2_msgs_msg_dds__TFMessage_ message{};
  message.transforms._buffer = transforms.data();
  message.transforms._length = message.transforms._maximum = static_cast<std::uint32_t>(transforms.size());
  return message;
}

std::vector<std::string> variableNames(const kinematics::RobotModel& model) {
  std::vector<std::string> names;
  for (const int joint : model.moving) names.push_back(model.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

/// Everything that is published of one cell.
class CellPublisher {
 public:
  CellPublisher(RosNode& node, const workcell::Document& document, std::shared_ptr<const Entity> robot,
                std::optional<manipulation::MotionReplay> replay, bool simulated_clock)
      : node_(node),
        document_(document),
        robot_(std::move(robot)),
        replay_(std::move(replay)),
        frames_(*robot_->robot()),
        joint_state_(variableNames(*robot_->robot())),
        simulated_clock_(simulated_clock),
        base_moves_(baseMoves()) {}

  Expected<void> open() {
    const std::pair<Topic*, std::pair<const char*, const dds_topic_descriptor_t*>> topics[] = {
        {&description_, {"/robot_description", &std_msgs_msg_dds__String__desc}},
        {&static_frames_, {"/tf_static", &tf2_msgs_msg_dds__TFMessage__desc}},
        {&scene_, {"/planning_scene", &moveit_msgs_msg_dds__PlanningScene__desc}},
        {&moving_frames_, {"/tf", &tf2_msgs_msg_dds__TFMessage__desc}},
        {&joints_, {"/joint_states", &sensor_msgs_msg_dds__JointState__desc}},
        {&moved_, {"/moved/pose", &geometry_msgs_msg_dds__PoseStamped__desc}},
        {&wrench_, {"/moved/wrench", &geometry_msgs_msg_dds__WrenchStamped__desc}},
        {&clock_, {"/clock", &rosgraph_msgs_msg_dds__Clock__desc}}};
    for (const auto& [topic, what] : topics) {
      if (topic == &clock_ && !simulated_clock_) continue;
      if ((topic == &moved_ || topic == &wrench_) && !replay_) continue;
      const bool is_latched = topic == &description_ || topic == &static_frames_ || topic == &scene_;
      RosQuality quality = is_latched ? RosQuality::kLatched : RosQuality::kDefault;
      if (topic == &moving_frames_) quality = RosQuality::kTransforms;
      HAPTICELL_TRY(openTopic(*topic, what.first, *what.second, quality));
    }
    return {};
  }

  Expected<void> openStylus() {
    HAPTICELL_TRY(openTopic(stylus_, "/stylus/pose", geometry_msgs_msg_dds__PoseStamped__desc, RosQuality::kDefault));
    return openTopic(force_, "/stylus/wrench", geometry_msgs_msg_dds__WrenchStamped__desc, RosQuality::kDefault);
  }

  /// From now on the contacts of the motion are published too.
  Expected<void> openContacts(std::unique_ptr<ContactMarkers> markers) {
    markers_ = std::move(markers);
    return openTopic(contacts_, "/contact_markers", visualization_msgs_msg_dds__MarkerArray__desc, RosQuality::kDefault);
  }

  /// Description, static frames and planning scene, for all who come.
  Expected<void> publishLatched(std::string description) {
    std_msgs_msg_dds__String_ text{description.data()};
    HAPTICELL_TRY(put(description_, &text));
    const std::int64_t stamp = stampOf(0.0);
    auto transforms = frames_.at(robot_->joints(), false, stamp);
    const std::string root = robot_->robot()->links.front().name;
    if (!base_moves_) transforms.push_back(rosTransform(stamp, kWorldName, root, robot_->X_WE));
    const auto message = messageOf(transforms);
    HAPTICELL_TRY(put(static_frames_, &message));
    PlanningSceneMessage scene;
    for (const auto& entity : document_.state().entities)
      if (entity->mesh() && entity->attachment.to.empty()) scene.addObject(entity->name, entity->X_WE, *entity->mesh());
    moveit_msgs_msg_dds__PlanningScene_ changed = *scene.message(stamp, robot_->robot()->name, nullptr);
    changed.is_diff = true;  // Objects are added to what the reader has.
    return put(scene_, &changed);
  }

  /// What changes, `t` seconds after the beginning; `motion_time` is the time within the motion.
  Expected<void> publishMoment(double t, double motion_time) {
    const std::int64_t stamp = stampOf(t);
    if (simulated_clock_) {
      const auto header = rosHeader(stamp, kWorldName);
      const rosgraph_msgs_msg_dds__Clock_ clock{header.stamp};
      HAPTICELL_TRY(put(clock_, &clock));
    }
    const EntityConfiguration at = replay_ ? replay_->at(motion_time) : EntityConfiguration{robot_->X_WE, robot_->joints()};
    HAPTICELL_TRY(put(joints_, joint_state_.at(stamp, at.joints)));
    auto transforms = frames_.at(at.joints, true, stamp);
    const std::string root = robot_->robot()->links.front().name;
    if (base_moves_) transforms.push_back(rosTransform(stamp, kWorldName, root, at.X_WE));
    const auto message = messageOf(transforms);
    HAPTICELL_TRY(put(moving_frames_, &message));
    if (markers_)
      if (const auto* const changed = markers_->update(stamp, motion_time)) HAPTICELL_TRY(put(contacts_, changed));
    return replay_ ? publishMoved(stamp, motion_time, at) : Expected<void>();
  }

  Expected<void> publishStylus(const haptic::HapticState& state, double t) {
    static const std::string kDevice = kDeviceFrame;
    const auto header = rosHeader(stampOf(t), kDevice);
    const geometry_msgs_msg_dds__PoseStamped_ pose{header, rosPose(state.X_DS)};
    HAPTICELL_TRY(put(stylus_, &pose));
    const geometry_msgs_msg_dds__WrenchStamped_ wrench{
        header, {{state.force_D.x, state.force_D.y, state.force_D.z}, {state.torque_D.x, state.torque_D.y, state.torque_D.z}}};
    return put(force_, &wrench);
  }

  /// At the end, `t` seconds after the beginning: contacts are no longer shown.
  Expected<void> publishEnd(double t) {
    const auto* const changed = markers_ ? markers_->clear(stampOf(t)) : nullptr;
    return changed ? put(contacts_, changed) : Expected<void>();
  }

  ordered_json result() const {
    ordered_json published, readers;
    for (const Topic* topic : {&description_, &joints_, &moving_frames_, &static_frames_, &scene_, &moved_, &wrench_,
                               &clock_, &stylus_, &force_, &contacts_}) {
      if (topic->writer == 0) continue;
      published[topic->name] = topic->count;
      readers[topic->name] = node_.readersOf(topic->writer);
    }
    return {{"robot", robot_->name}, {"published", published}, {"readers", readers}};
  }

 private:
  Expected<void> openTopic(Topic& topic, const char* name, const dds_topic_descriptor_t& type, RosQuality quality) {
    const auto writer = node_.advertise(name, type, quality);
    HAPTICELL_TRY(writer);
    topic.writer = *writer;
    topic.name = name;
    return {};
  }

  Expected<void> put(Topic& topic, const void* message) {
    ++topic.count;
    return node_.write(topic.writer, message);
  }

  Expected<void> publishMoved(std::int64_t stamp, double motion_time, const EntityConfiguration& at) {
    const auto header = rosHeader(stamp, kWorldName);
    const geometry_msgs_msg_dds__PoseStamped_ pose{header, rosPose(replay_->movedFrame(at))};
    HAPTICELL_TRY(put(moved_, &pose));
    const trajectory::Trajectory& motion = replay_->motion();
    const auto x = motion.findChannel("force_x"), y = motion.findChannel("force_y"), z = motion.findChannel("force_z");
    if (!x || !y || !z) return {};
    const auto frames = motion.frames();
    const auto after = std::upper_bound(frames.begin(), frames.end(), motion_time,
                                        [](double time, const auto& frame) { return time < frame.t; });
    const auto values = motion.channels(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - frames.begin() - 1)));
    const geometry_msgs_msg_dds__WrenchStamped_ wrench{header, {{values[*x], values[*y], values[*z]}, {0.0, 0.0, 0.0}}};
    return put(wrench_, &wrench);
  }

  bool baseMoves() const {
    if (!replay_) return false;
    const Pose first = replay_->at(replay_->motion()[0].t).X_WE;
    return std::ranges::any_of(replay_->motion().frames(),
                               [&](const auto& frame) { return replay_->at(frame.t).X_WE.p != first.p; });
  }

  std::int64_t stampOf(double t) const {
    if (simulated_clock_) return std::llround(1e9 * t);
    return dds_time();  // Stamps of ROS are nanoseconds since 1970.
  }

  const std::string kWorldName = kWorldFrame;
  RosNode& node_;
  const workcell::Document& document_;
  std::shared_ptr<const Entity> robot_;
  std::optional<manipulation::MotionReplay> replay_;
  RobotFrames frames_;
  JointStateMessage joint_state_;
  bool simulated_clock_, base_moves_;
  Topic description_, static_frames_, scene_, moving_frames_, joints_, moved_, wrench_, clock_, stylus_, force_, contacts_;
  std::unique_ptr<ContactMarkers> markers_;
};

Expected<std::optional<manipulation::MotionReplay>> replayOf(const workcell::Document& document, const Entity& robot,
                                                             const PublishOptions& options, std::vector<Text>& notes) {
  if (options.motion.empty()) return std::nullopt;
  auto motion = exchange::isMcapFile(options.motion) ? exchange::readMcapMotion(options.motion, {}, &notes)
                                                     : trajectory::readTrajectory(options.motion, &notes);
  HAPTICELL_TRY(motion);
  auto replay = manipulation::MotionReplay::create(document.state().entities, robot.name,
                                                   std::make_shared<const trajectory::Trajectory>(std::move(*motion)));
  if (!replay) {
    replay.error().file = options.motion;
    return tl::unexpected(replay.error());
  }
  return std::optional(std::move(*replay));
}

/// The motion, sent once to a controller that listens.
Expected<void> sendTrajectory(RosNode& node, const manipulation::MotionReplay& replay, const PublishOptions& options,
                              const std::atomic<bool>& stop) {
  const trajectory::Trajectory motion = replay.withJoints();
  if (!motion.hasJoints())
    return makeError({options.motion, "joints", "none", "a motion of a robot", ""});
  const auto writer =
      node.advertise(options.trajectory_topic, trajectory_msgs_msg_dds__JointTrajectory__desc, RosQuality::kDefault);
  HAPTICELL_TRY(writer);
  const auto end = Clock::now() + std::chrono::duration<double>(options.wait);
  while (node.readersOf(*writer) == 0) {
    if (Clock::now() > end || stop)
      return makeError({options.trajectory_topic, "", "no reader", "a controller that listens on this topic",
                        "Start the controller, or use a longer --wait."});
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const JointTrajectoryMessage message(motion);
  HAPTICELL_TRY(node.write(*writer, message.message()));
  if (!node.flush(options.wait))
    return makeError({options.trajectory_topic, "", "the reader did not acknowledge the motion", "an acknowledgement", ""});
  return {};
}

Expected<std::unique_ptr<haptic::TcpLink>> watchedServer(const std::string& server) {
  if (server.empty()) return std::unique_ptr<haptic::TcpLink>();
  const std::size_t colon = server.rfind(':');
  return haptic::watchServer(server.substr(0, colon), static_cast<std::uint16_t>(std::atoi(server.c_str() + colon + 1)),
                             "hapticell-ros2");
}

}  // namespace

Expected<ordered_json> publishCell(const PublishOptions& options, const std::atomic<bool>& stop) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.workcell, notes);
  HAPTICELL_TRY(document);
  const auto robot = robotOf(*document, options);
  HAPTICELL_TRY(robot);
  auto replay = replayOf(*document, **robot, options, notes.warnings);
  HAPTICELL_TRY(replay);
  if (!options.trajectory_topic.empty() && !*replay)
    return makeError({"", "--trajectory", "--motion is missing", "a motion to send", ""});
  if (options.contacts && !*replay) return makeError({"", "--contacts", "--motion is missing", "a motion", ""});
  const auto scratch = ScratchFolder::make();
  HAPTICELL_TRY(scratch);
  auto description = robotDescription(**robot, options.folder.empty() ? scratch->path() : fs::path(options.folder), notes);
  HAPTICELL_TRY(description);
  const auto link = watchedServer(options.server);
  HAPTICELL_TRY(link);
  auto node = RosNode::create(options.node);
  HAPTICELL_TRY(node);
  CellPublisher publisher(**node, *document, *robot, *replay, options.simulated_clock);
  HAPTICELL_TRY(publisher.open());
  if (*link) HAPTICELL_TRY(publisher.openStylus());
  if (options.contacts) {
    auto markers = ContactMarkers::create(*document, (*robot)->name, **replay, options.rate_hz);
    HAPTICELL_TRY(markers);
    HAPTICELL_TRY(publisher.openContacts(std::move(*markers)));
  }
  HAPTICELL_TRY(publisher.publishLatched(std::move(*description)));
  if (!options.trajectory_topic.empty()) HAPTICELL_TRY(sendTrajectory(**node, **replay, options, stop));

  const double start = *replay ? (*replay)->motion()[0].t : 0.0;
  const double duration = *replay ? (*replay)->motion().duration() : 0.0;
  const double length = options.seconds > 0.0 || options.repeat ? options.seconds : duration;
  const bool is_endless = options.seconds == 0.0 && (!*replay || options.repeat);
  const auto begin = Clock::now();
  std::uint64_t ticks = 0, late = 0;
  for (; !stop; ++ticks) {
    const double t = static_cast<double>(ticks) / options.rate_hz;
    if (!is_endless && t > std::max(length, options.repeat ? 0.0 : duration)) break;
    const auto due = begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(t));
    std::this_thread::sleep_until(due);
    if (Clock::now() - due > std::chrono::milliseconds(5)) ++late;
    const double moved = options.repeat && duration > 0.0 ? std::fmod(t, duration) : std::min(t, duration);
    HAPTICELL_TRY(publisher.publishMoment(t, start + moved));
    if (!*link) continue;
    if (const auto state = (*link)->latestState()) HAPTICELL_TRY(publisher.publishStylus(*state, t));
  }
  HAPTICELL_TRY(publisher.publishEnd(static_cast<double>(ticks) / options.rate_hz));
  ordered_json result = publisher.result();
  (*node)->flush(1.0);
  result["ticks"] = ticks;
  result["late_5ms"] = late;
  result["assumptions"] = ordered_json::array();
  for (const Text& note : notes.warnings) result["assumptions"].push_back(english(note));
  return result;
}

}  // namespace hapticell::bridge
