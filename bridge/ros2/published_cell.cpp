// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/published_cell.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "geometry/system/regular_file.h"
#include "workcell/robots/urdf_writer.h"

namespace hapticell::bridge {

namespace {

namespace fs = std::filesystem;
using manipulation::EntityConfiguration;
using nlohmann::ordered_json;
using workcell::Entity;

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

/// The address of a local file, with all but letters, digits, "-._~" and "/" as percent codes (RFC 3986): then it stands
/// in XML as it is.
std::string addressOf(const fs::path& file) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string address = "file://";
  for (const char letter : file.string()) {
    const auto code = static_cast<unsigned char>(letter);
    const bool is_plain = (code < 128 && std::isalnum(code)) || std::strchr("-._~/", letter) != nullptr;
    if (is_plain) {
      address += letter;
    } else {
      address += {'%', kDigits[code >> 4], kDigits[code & 15]};
    }
  }
  return address;
}

}  // namespace

Expected<std::string> robotDescription(const Entity& robot, const fs::path& folder, Diagnostics& notes) {
  const fs::path file = fs::absolute(folder) / "robot.urdf";
  HAPTICELL_TRY(workcell::writeUrdf(robot, file, notes));
  auto text = geometry::readRegularFile(file);
  HAPTICELL_TRY(text);
  const std::string relative = "filename=\"robot_meshes/", whole = "filename=\"" + addressOf(file.parent_path() / "robot_meshes") + "/";
  for (std::size_t at = text->find(relative); at != std::string::npos; at = text->find(relative, at + whole.size()))
    text->replace(at, relative.size(), whole);
  return text;
}

std::vector<geometry_msgs_msg_dds__TransformStamped_> RobotFrames::at(const std::vector<double>& q, bool moving,
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

PublishedCell::PublishedCell(RosNode& node, const workcell::Document& document, std::shared_ptr<const Entity> robot,
                             std::optional<manipulation::MotionReplay> replay, bool simulated_clock)
    : node_(node),
      document_(document),
      robot_(std::move(robot)),
      replay_(std::move(replay)),
      frames_(*robot_->robot()),
      joint_state_(variableNames(*robot_->robot())),
      simulated_clock_(simulated_clock),
      base_moves_(baseMoves()) {}

Expected<void> PublishedCell::open() {
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

Expected<void> PublishedCell::openStylus() {
  HAPTICELL_TRY(openTopic(stylus_, "/stylus/pose", geometry_msgs_msg_dds__PoseStamped__desc, RosQuality::kDefault));
  return openTopic(force_, "/stylus/wrench", geometry_msgs_msg_dds__WrenchStamped__desc, RosQuality::kDefault);
}

Expected<void> PublishedCell::openContacts(std::unique_ptr<ContactMarkers> markers) {
  markers_ = std::move(markers);
  return openTopic(contacts_, "/contact_markers", visualization_msgs_msg_dds__MarkerArray__desc, RosQuality::kDefault);
}

Expected<void> PublishedCell::publishLatched(std::string description) {
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

Expected<void> PublishedCell::publishMoment(double t, double motion_time) {
  const EntityConfiguration at = replay_ ? replay_->at(motion_time) : EntityConfiguration{robot_->X_WE, robot_->joints()};
  HAPTICELL_TRY(publishAt(t, at));
  const std::int64_t stamp = stampOf(t);
  if (markers_)
    if (const auto* const changed = markers_->update(stamp, motion_time)) HAPTICELL_TRY(put(contacts_, changed));
  return replay_ ? publishMoved(stamp, motion_time, at) : Expected<void>();
}

Expected<void> PublishedCell::publishAt(double t, const EntityConfiguration& at) {
  const std::int64_t stamp = stampOf(t);
  if (simulated_clock_) {
    const auto header = rosHeader(stamp, kWorldName);
    const rosgraph_msgs_msg_dds__Clock_ clock{header.stamp};
    HAPTICELL_TRY(put(clock_, &clock));
  }
  HAPTICELL_TRY(put(joints_, joint_state_.at(stamp, at.joints)));
  auto transforms = frames_.at(at.joints, true, stamp);
  const std::string root = robot_->robot()->links.front().name;
  if (base_moves_) transforms.push_back(rosTransform(stamp, kWorldName, root, at.X_WE));
  const auto message = messageOf(transforms);
  return put(moving_frames_, &message);
}

Expected<void> PublishedCell::publishStylus(const haptic::HapticState& state, double t) {
  static const std::string kDevice = "device";
  const auto header = rosHeader(stampOf(t), kDevice);
  const geometry_msgs_msg_dds__PoseStamped_ pose{header, rosPose(state.X_DS)};
  HAPTICELL_TRY(put(stylus_, &pose));
  const geometry_msgs_msg_dds__WrenchStamped_ wrench{
      header, {{state.force_D.x, state.force_D.y, state.force_D.z}, {state.torque_D.x, state.torque_D.y, state.torque_D.z}}};
  return put(force_, &wrench);
}

Expected<void> PublishedCell::publishEnd(double t) {
  const auto* const changed = markers_ ? markers_->clear(stampOf(t)) : nullptr;
  return changed ? put(contacts_, changed) : Expected<void>();
}

ordered_json PublishedCell::result() const {
  ordered_json published, readers;
  for (const Topic* topic : {&description_, &joints_, &moving_frames_, &static_frames_, &scene_, &moved_, &wrench_,
                             &clock_, &stylus_, &force_, &contacts_}) {
    if (topic->writer == 0) continue;
    published[topic->name] = topic->count;
    readers[topic->name] = node_.readersOf(topic->writer);
  }
  return {{"robot", robot_->name}, {"published", published}, {"readers", readers}};
}

Expected<void> PublishedCell::openTopic(Topic& topic, const char* name, const dds_topic_descriptor_t& type, RosQuality quality) {
  const auto writer = node_.advertise(name, type, quality);
  HAPTICELL_TRY(writer);
  topic.writer = *writer;
  topic.name = name;
  return {};
}

Expected<void> PublishedCell::put(Topic& topic, const void* message) {
  ++topic.count;
  return node_.write(topic.writer, message);
}

Expected<void> PublishedCell::publishMoved(std::int64_t stamp, double motion_time, const EntityConfiguration& at) {
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

bool PublishedCell::baseMoves() const {
  if (!replay_) return false;
  const Pose first = replay_->at(replay_->motion()[0].t).X_WE;
  return std::ranges::any_of(replay_->motion().frames(),
                             [&](const auto& frame) { return replay_->at(frame.t).X_WE.p != first.p; });
}

std::int64_t PublishedCell::stampOf(double t) const {
  if (simulated_clock_) return std::llround(1e9 * t);
  return dds_time();  // Stamps of ROS are nanoseconds since 1970.
}

}  // namespace hapticell::bridge
