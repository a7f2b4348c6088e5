// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros2_messages.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle_mesh.h"
#include "trajectory/motion/trajectory.h"
#include "geometry/system/error.h"

namespace hapticell::bridge {

/// Messages of ROS 2 as Cyclone DDS has them in memory. Texts and numbers are borrowed: what is handed in must outlive
/// the message, and nothing of it is freed.

std_msgs_msg_dds__Header_ rosHeader(std::int64_t stamp_ns, const std::string& frame);
geometry_msgs_msg_dds__Pose_ rosPose(const Pose& pose);
geometry_msgs_msg_dds__TransformStamped_ rosTransform(std::int64_t stamp_ns, const std::string& frame,
                                                      const std::string& child, const Pose& pose);

/// A JointState with lists that belong to it.
class JointStateMessage {
 public:
  explicit JointStateMessage(std::vector<std::string> names);
  /// @pre as many positions as names; velocities none or as many
  const sensor_msgs_msg_dds__JointState_* at(std::int64_t stamp_ns, std::vector<double> positions,
                                             std::vector<double> velocities = {});

 private:
  std::vector<std::string> names_;
  std::vector<char*> name_pointers_;
  std::vector<double> positions_, velocities_;
  sensor_msgs_msg_dds__JointState_ message_{};
};

/// A JointTrajectory of a motion: positions with velocities by central differences, times from the first frame on.
class JointTrajectoryMessage {
 public:
  /// @pre the motion has joints and frames
  explicit JointTrajectoryMessage(const trajectory::Trajectory& motion);
  const trajectory_msgs_msg_dds__JointTrajectory_* message() const { return &message_; }

 private:
  std::vector<std::string> names_;
  std::vector<char*> name_pointers_;
  std::deque<std::vector<double>> numbers_;
  std::vector<trajectory_msgs_msg_dds__JointTrajectoryPoint_> points_;
  trajectory_msgs_msg_dds__JointTrajectory_ message_{};
};

/// A PlanningScene with meshes and the state of the robot.
class PlanningSceneMessage {
 public:
  /// A mesh in the world; triangles turned outwards.
  void addObject(const std::string& id, const Pose& X_WO, const geometry::TriangleMesh& mesh);
  /// `state` may be null. The pointers live as long as this object and `state`.
  const moveit_msgs_msg_dds__PlanningScene_* message(std::int64_t stamp_ns, const std::string& robot,
                                                     const sensor_msgs_msg_dds__JointState_* state);
  std::size_t size() const { return objects_.size(); }

 private:
  struct Object {
    std::string id;
    std::vector<geometry_msgs_msg_dds__Point_> vertices;
    std::vector<shape_msgs_msg_dds__MeshTriangle_> triangles;
    shape_msgs_msg_dds__Mesh_ mesh{};
    geometry_msgs_msg_dds__Pose_ pose{}, mesh_pose{};
  };
  std::deque<Object> objects_;
  std::vector<moveit_msgs_msg_dds__CollisionObject_> list_;
  std::string robot_;
  moveit_msgs_msg_dds__PlanningScene_ message_{};
};

/// A JointTrajectory as a motion of joints. Errors: no joints or points, points with other numbers of positions, times
/// that do not rise, numbers that are not finite.
Expected<trajectory::Trajectory> motionOf(const trajectory_msgs_msg_dds__JointTrajectory_& message);

/// Nanoseconds of a stamp.
std::int64_t nanosecondsOf(const builtin_interfaces_msg_dds__Time_& time);

}  // namespace hapticell::bridge
