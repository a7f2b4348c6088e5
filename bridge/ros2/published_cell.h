// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bridge/ros2/contact_markers.h"
#include "bridge/ros2/ros_conversion.h"
#include "bridge/ros2/ros_node.h"
#include "geometry/system/error.h"
#include "haptic/protocol/messages.h"
#include "kinematics/model/robot_model.h"
#include "manipulation/checks/motion_replay.h"
#include "workcell/document/document.h"

namespace hapticell::bridge {

/// The robot's URDF with meshes as file:// addresses, so that every program of this machine finds them. They are written
/// to `folder`. Errors: files that cannot be written.
Expected<std::string> robotDescription(const workcell::Entity& robot, const std::filesystem::path& folder,
                                       Diagnostics& notes);

/// Link poses as /tf has them: each link in its parent link. The model must outlive it.
class RobotFrames {
 public:
  explicit RobotFrames(const kinematics::RobotModel& model) : model_(model) {}

  /// Transforms of fixed joints (`moving` false) or of the others.
  std::vector<geometry_msgs_msg_dds__TransformStamped_> at(const std::vector<double>& q, bool moving, std::int64_t stamp_ns);

 private:
  const kinematics::RobotModel& model_;
  std::vector<Pose> X_BL_;
};

/// Everything that is published of one cell, with its topics. One thread. Node and document must outlive it.
class PublishedCell {
 public:
  /// `replay`: what the robot does; empty: it rests, or is where publishAt() says. `simulated_clock`: /clock, and stamps
  /// from 0 instead of the time of day.
  PublishedCell(RosNode& node, const workcell::Document& document, std::shared_ptr<const workcell::Entity> robot,
                std::optional<manipulation::MotionReplay> replay, bool simulated_clock);

  /// Errors, here and below: what DDS says.
  Expected<void> open();
  Expected<void> openStylus();
  /// The robot's base goes to /tf with every moment, not to /tf_static once. Call it before publishLatched().
  void letBaseMove() { base_moves_ = true; }
  /// From now on the contacts of the motion are published too.
  Expected<void> openContacts(std::unique_ptr<ContactMarkers> markers);
  /// Description, static frames and planning scene, for all who come.
  Expected<void> publishLatched(std::string description);
  /// What changes, `t` seconds after the beginning; `motion_time` is the time within the motion.
  Expected<void> publishMoment(double t, double motion_time);
  /// Joints and frames with the robot there. @pre a number for each variable
  Expected<void> publishAt(double t, const manipulation::EntityConfiguration& at);
  Expected<void> publishStylus(const haptic::HapticState& state, double t);
  /// At the end, `t` seconds after the beginning: contacts are no longer shown.
  Expected<void> publishEnd(double t);

  /// `robot`, and by topic what was `published` and how many `readers` there are.
  nlohmann::ordered_json result() const;

 private:
  /// A topic with its writer and how often it was written.
  struct Topic {
    dds_entity_t writer = 0;
    std::string name;
    std::uint64_t count = 0;
  };
  Expected<void> openTopic(Topic& topic, const char* name, const dds_topic_descriptor_t& type, RosQuality quality);
  Expected<void> put(Topic& topic, const void* message);
  Expected<void> publishMoved(std::int64_t stamp, double motion_time, const manipulation::EntityConfiguration& at);
  bool baseMoves() const;
  std::int64_t stampOf(double t) const;

  const std::string kWorldName = "world";  // NOLINT(readability-identifier-naming)
  RosNode& node_;
  const workcell::Document& document_;
  std::shared_ptr<const workcell::Entity> robot_;
  std::optional<manipulation::MotionReplay> replay_;
  RobotFrames frames_;
  JointStateMessage joint_state_;
  bool simulated_clock_, base_moves_;
  Topic description_, static_frames_, scene_, moving_frames_, joints_, moved_, wrench_, clock_, stylus_, force_, contacts_;
  std::unique_ptr<ContactMarkers> markers_;
};

}  // namespace hapticell::bridge
