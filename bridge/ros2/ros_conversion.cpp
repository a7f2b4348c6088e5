// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/ros_conversion.h"

#include <algorithm>
#include <cmath>

namespace hapticell::bridge {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr const char* kWorld = "world";

/// DDS has no const in its structures; a message that is written is not changed.
char* borrowed(const std::string& text) {
  return const_cast<char*>(text.c_str());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

template <typename Sequence, typename T>
void lend(Sequence& sequence, std::vector<T>& list) {
  sequence._buffer = list.data();
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(list.size());
  sequence._release = false;
}

std::vector<char*> pointersTo(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(borrowed(text));
  return pointers;
}

template <typename Sequence>
std::vector<double> numbersOf(const Sequence& sequence) {
  return {sequence._buffer, sequence._buffer + sequence._length};
}

}  // namespace

std::int64_t nanosecondsOf(const builtin_interfaces_msg_dds__Time_& time) {
  return time.sec * kSecond + time.nanosec;
}

std_msgs_msg_dds__Header_ rosHeader(std::int64_t stamp_ns, const std::string& frame) {
  return {{static_cast<std::int32_t>(stamp_ns / kSecond), static_cast<std::uint32_t>(stamp_ns % kSecond)},
          borrowed(frame)};
}

geometry_msgs_msg_dds__Pose_ rosPose(const Pose& pose) {
  return {{pose.p.x, pose.p.y, pose.p.z}, {pose.q.x, pose.q.y, pose.q.z, pose.q.w}};
}

geometry_msgs_msg_dds__TransformStamped_ rosTransform(std::int64_t stamp_ns, const std::string& frame,
                                                      const std::string& child, const Pose& pose) {
  return {rosHeader(stamp_ns, frame), borrowed(child),
          {{pose.p.x, pose.p.y, pose.p.z}, {pose.q.x, pose.q.y, pose.q.z, pose.q.w}}};
}

JointStateMessage::JointStateMessage(std::vector<std::string> names)
    : names_(std::move(names)), name_pointers_(pointersTo(names_)) {}

const sensor_msgs_msg_dds__JointState_* JointStateMessage::at(std::int64_t stamp_ns, std::vector<double> positions,
                                                              std::vector<double> velocities) {
  static const std::string kNoFrame;
  positions_ = std::move(positions);
  velocities_ = std::move(velocities);
  message_ = {};
  message_.header = rosHeader(stamp_ns, kNoFrame);
  lend(message_.name, name_pointers_);
  lend(message_.position, positions_);
  lend(message_.velocity, velocities_);
  return &message_;
}

JointTrajectoryMessage::JointTrajectoryMessage(const trajectory::Trajectory& motion)
    : names_(motion.joint_names), name_pointers_(pointersTo(names_)) {
  static const std::string kNoFrame;
  const std::size_t last = motion.size() - 1;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const auto joints = motion.joints(i);
    std::vector<double>& positions = numbers_.emplace_back(joints.begin(), joints.end());
    std::vector<double>& velocities = numbers_.emplace_back(joints.size(), 0.0);
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, last);
    const double step = motion[after].t - motion[before].t;
    // At rest at both ends, as controllers ask for.
    if (i > 0 && i < last)
      for (std::size_t k = 0; k < joints.size(); ++k)
        velocities[k] = (motion.joints(after)[k] - motion.joints(before)[k]) / step;
    trajectory_msgs_msg_dds__JointTrajectoryPoint_ point{};
    lend(point.positions, positions);
    lend(point.velocities, velocities);
    const std::int64_t time = std::llround(1e9 * (motion[i].t - motion[0].t));
    point.time_from_start = {static_cast<std::int32_t>(time / kSecond), static_cast<std::uint32_t>(time % kSecond)};
    points_.push_back(point);
  }
  message_.header = rosHeader(0, kNoFrame);  // 0: as soon as it comes.
  lend(message_.joint_names, name_pointers_);
  lend(message_.points, points_);
}

void PlanningSceneMessage::addObject(const std::string& id, const Pose& X_WO, const geometry::TriangleMesh& mesh) {
  Object& object = objects_.emplace_back();
  object.id = id;
  object.pose = rosPose(X_WO);
  object.mesh_pose = rosPose(Pose::identity());
  for (const dvec3& vertex : mesh.vertices) object.vertices.push_back({vertex.x, vertex.y, vertex.z});
  for (const auto& triangle : mesh.triangles)
    object.triangles.push_back({{triangle[0], triangle[1], triangle[2]}});
  lend(object.mesh.triangles, object.triangles);
  lend(object.mesh.vertices, object.vertices);
}

const moveit_msgs_msg_dds__PlanningScene_* PlanningSceneMessage::message(
    std::int64_t stamp_ns, const std::string& robot, const sensor_msgs_msg_dds__JointState_* state) {
  static const std::string kFrame = kWorld, kName = "HaptiCell";
  robot_ = robot;
  list_.clear();
  for (Object& object : objects_) {
    moveit_msgs_msg_dds__CollisionObject_ entry{};
    entry.header = rosHeader(stamp_ns, kFrame);
    entry.id = borrowed(object.id);
    entry.pose = object.pose;
    entry.meshes._buffer = &object.mesh;
    entry.mesh_poses._buffer = &object.mesh_pose;
    entry.meshes._length = entry.meshes._maximum = 1;
    entry.mesh_poses._length = entry.mesh_poses._maximum = 1;
    list_.push_back(entry);
  }
  message_ = {};
  message_.name = borrowed(kName);
  message_.robot_model_name = borrowed(robot_);
  if (state) message_.robot_state.joint_state = *state;
  message_.robot_state.is_diff = state == nullptr;
  lend(message_.world.collision_objects, list_);
  message_.world.octomap.origin.orientation.w = 1.0;
  return &message_;
}

Expected<trajectory::Trajectory> motionOf(const trajectory_msgs_msg_dds__JointTrajectory_& message) {
  trajectory::Trajectory motion;
  motion.has_poses = false;
  for (std::uint32_t i = 0; i < message.joint_names._length; ++i)
    motion.joint_names.emplace_back(message.joint_names._buffer[i] ? message.joint_names._buffer[i] : "");
  if (motion.joint_names.empty() || message.points._length == 0)
    return makeError({.place = "JointTrajectory", .found = "no joints or no points", .expected = "a motion"});
  for (std::uint32_t i = 0; i < message.points._length; ++i) {
    const auto& point = message.points._buffer[i];
    const std::vector<double> positions = numbersOf(point.positions);
    const bool fits = positions.size() == motion.joint_names.size() &&
                      std::all_of(positions.begin(), positions.end(), [](double q) { return std::isfinite(q); });
    const double t = static_cast<double>(point.time_from_start.sec * kSecond + point.time_from_start.nanosec) / 1e9;
    if (!fits || !motion.addFrame({t, {}}, positions))
      return makeError({.place = Text("JointTrajectory, point %1", i + 0),
                        .found = "positions that do not fit the joints, or a time that does not rise",
                        .expected = "one finite position for each joint and rising times"});
  }
  return motion;
}

}  // namespace hapticell::bridge
