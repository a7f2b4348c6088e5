// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/ros_listener.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <thread>

#include "bridge/ros2/collision_objects.h"
#include "bridge/ros2/ros_conversion.h"
#include "bridge/ros2/taken_samples.h"
#include "geometry/system/atomic_file.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/document/command.h"
#include "workcell/format/document_io.h"

namespace hapticell::bridge {

namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::ordered_json;
using trajectory::Trajectory;

/// Joint states of one robot as a motion, and the last position of every joint that was heard.
class HeardJoints {
 public:
  void take(const sensor_msgs_msg_dds__JointState_& state) {
    ++count_;
    if (state.position._length != state.name._length || state.name._length == 0) {
      ++odd_;
      return;
    }
    std::vector<std::string> names;
    std::vector<double> positions(state.position._buffer, state.position._buffer + state.position._length);
    for (std::uint32_t i = 0; i < state.name._length; ++i) names.emplace_back(state.name._buffer[i] ? state.name._buffer[i] : "");
    if (!std::all_of(positions.begin(), positions.end(), [](double q) { return std::isfinite(q); })) {
      ++odd_;
      return;
    }
    for (std::size_t i = 0; i < names.size(); ++i) last_[names[i]] = positions[i];
    if (motion_.joint_names.empty()) {
      motion_.joint_names = names;
      motion_.has_poses = false;
      start_ns_ = nanosecondsOf(state.header.stamp);
    }
    const double t = static_cast<double>(nanosecondsOf(state.header.stamp) - start_ns_) / 1e9;
    if (names != motion_.joint_names || !motion_.addFrame({t, {}}, positions)) ++odd_;
  }

  std::uint64_t count() const { return count_; }
  std::uint64_t odd() const { return odd_; }
  const Trajectory& motion() const { return motion_; }
  const std::map<std::string, double>& last() const { return last_; }

 private:
  Trajectory motion_;
  std::map<std::string, double> last_;
  std::int64_t start_ns_ = 0;
  std::uint64_t count_ = 0, odd_ = 0;
};

/// Readers for what was asked for; 0: not asked.
struct Readers {
  dds_entity_t joints = 0, trajectory = 0, description = 0, scene = 0, object = 0;
};

Expected<Readers> openReaders(RosNode& node, const ListenOptions& options) {
  Readers readers;
  if (!options.motion.empty() || !options.entity.empty()) {
    const auto reader = node.subscribe(options.joint_topic, sensor_msgs_msg_dds__JointState__desc, RosQuality::kSensor);
    HAPTICELL_TRY(reader);
    readers.joints = *reader;
  }
  if (!options.trajectory.empty()) {
    const auto reader =
        node.subscribe(options.trajectory_topic, trajectory_msgs_msg_dds__JointTrajectory__desc, RosQuality::kDefault);
    HAPTICELL_TRY(reader);
    readers.trajectory = *reader;
  }
  if (!options.description.empty()) {
    const auto reader = node.subscribe(options.description_topic, std_msgs_msg_dds__String__desc, RosQuality::kLatched);
    HAPTICELL_TRY(reader);
    readers.description = *reader;
  }
  if (options.objects) {
    const auto scene = node.subscribe("/planning_scene", moveit_msgs_msg_dds__PlanningScene__desc, RosQuality::kLatched);
    HAPTICELL_TRY(scene);
    const auto object =
        node.subscribe("/collision_object", moveit_msgs_msg_dds__CollisionObject__desc, RosQuality::kDefault);
    HAPTICELL_TRY(object);
    readers.scene = *scene;
    readers.object = *object;
  }
  if (readers.joints == 0 && readers.trajectory == 0 && readers.description == 0 && readers.scene == 0)
    return makeError({.place = "ros2 listen",
                      .found = "nothing to listen for",
                      .expected = "--output, --trajectory, --description, --entity or --objects"});
  return readers;
}

tl::unexpected<Error> nothingCame(const std::string& topic, double seconds) {
  return makeError({.file = topic,
                    .found = Text("no message within %1 s", static_cast<std::int64_t>(std::ceil(seconds))),
                    .expected = "a program that publishes it",
                    .fix = "Check ROS_DOMAIN_ID on both sides, and that the network lets multicast through."});
}

/// Sets the robot's joints as they were heard.
Expected<void> mirrorRobot(workcell::Document& document, const ListenOptions& options,
                           const std::map<std::string, double>& last) {
  const workcell::Entity* const robot = document.findByName(options.entity);
  if (!robot || !workcell::isMachine(*robot))
    return makeError({.file = options.workcell,
                      .place = Text("entity '%1'", options.entity),
                      .found = "no robot of this name",
                      .expected = "a robot of the cell"});
  const kinematics::RobotModel& model = *robot->robot();
  std::vector<double> joints = robot->joints();
  std::size_t known = 0;
  std::string names;
  for (const auto& [name, position] : last) {
    names += (names.empty() ? "" : ", ") + name;
    const int joint = model.findJoint(name);
    const int variable = joint < 0 ? -1 : model.joints[static_cast<std::size_t>(joint)].variable;
    if (variable < 0) continue;
    joints[static_cast<std::size_t>(variable)] = position;
    ++known;
  }
  if (known == 0)
    return makeError({.file = options.joint_topic,
                      .found = Text("joints %1", names),
                      .expected = Text("joints of '%1'", options.entity)});
  const auto changed = document.execute(workcell::SetJoints{robot->id, joints});
  HAPTICELL_TRY(changed);
  return {};
}

/// The cell with what was heard, as a new file.
Expected<void> writeMirror(const ListenOptions& options, const HeardJoints& joints, const HeardObjects& objects) {
  Diagnostics ignored;
  auto document = workcell::loadDocument(options.workcell, ignored);
  HAPTICELL_TRY(document);
  if (!options.entity.empty()) HAPTICELL_TRY(mirrorRobot(*document, options, joints.last()));
  if (options.objects) HAPTICELL_TRY(objects.addTo(*document, options.mirrored));
  return workcell::saveDocument(*document, options.mirrored);
}

}  // namespace

Expected<ordered_json> listen(const ListenOptions& options, const std::atomic<bool>& stop) {
  auto node = RosNode::create(options.node);
  HAPTICELL_TRY(node);
  const auto readers = openReaders(**node, options);
  HAPTICELL_TRY(readers);
  HeardJoints joints;
  HeardObjects objects;
  std::optional<Expected<Trajectory>> trajectory;
  std::string description;
  std::size_t writers = 0;
  const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
  while (!stop && Clock::now() < end) {
    if (readers->joints != 0) {
      takeAll<sensor_msgs_msg_dds__JointState_>(readers->joints, [&](const auto& state) { joints.take(state); });
      writers = std::max(writers, (*node)->writersOf(readers->joints));
    }
    if (readers->trajectory != 0 && !trajectory)
      takeAll<trajectory_msgs_msg_dds__JointTrajectory_>(readers->trajectory, [&](const auto& message) {
        if (!trajectory) trajectory = motionOf(message);
      });
    if (readers->description != 0)
      takeAll<std_msgs_msg_dds__String_>(readers->description,
                                         [&](const auto& text) { description = text.data ? text.data : ""; });
    if (readers->scene != 0) {
      takeAll<moveit_msgs_msg_dds__PlanningScene_>(readers->scene, [&](const auto& scene) { objects.take(scene); });
      takeAll<moveit_msgs_msg_dds__CollisionObject_>(readers->object, [&](const auto& object) { objects.take(object); });
    }
    const bool has_all = (readers->trajectory == 0 || trajectory) && (readers->description == 0 || !description.empty());
    if (readers->joints == 0 && readers->scene == 0 && has_all) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  if (readers->joints != 0 && joints.motion().empty()) return nothingCame(options.joint_topic, options.seconds);
  if (readers->trajectory != 0 && !trajectory) return nothingCame(options.trajectory_topic, options.seconds);
  if (readers->description != 0 && description.empty()) return nothingCame(options.description_topic, options.seconds);
  if (readers->scene != 0 && objects.size() == 0) return nothingCame("/planning_scene", options.seconds);
  ordered_json result;
  std::vector<FileToWrite> files;
  const auto add_motion = [&](const std::string& file, const Trajectory& motion) {
    files.push_back({file, file.ends_with(".csv") ? toCsvText(motion) : toJsonText(motion)});
  };
  if (!options.motion.empty()) add_motion(options.motion, joints.motion());
  if (trajectory) {
    HAPTICELL_TRY(*trajectory);
    add_motion(options.trajectory, **trajectory);
    result["trajectory_points"] = (*trajectory)->size();
  }
  if (!description.empty()) files.push_back({options.description, description});
  if (!options.mirrored.empty()) HAPTICELL_TRY(writeMirror(options, joints, objects));
  HAPTICELL_TRY(writeFilesAtomically(files));
  result["joint_states"] = joints.count();
  result["frames"] = joints.motion().size();
  result["left_out"] = joints.odd();
  result["writers"] = writers;
  result["objects"] = objects.size();
  result["notes"] = ordered_json::array();
  for (const Text& note : objects.notes()) result["notes"].push_back(english(note));
  return result;
}

}  // namespace hapticell::bridge
