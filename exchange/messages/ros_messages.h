// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::exchange {

/// Messages of ROS 2 (Humble to Jazzy), with the fields of their public definitions. SI; quaternions become unit ones
/// where they are used, not here.

/// std_msgs/msg/Header. `stamp_ns`: nanoseconds of its clock, 0 or more.
struct RosHeader {
  std::int64_t stamp_ns = 0;
  std::string frame_id;
  bool operator==(const RosHeader&) const = default;
};

/// sensor_msgs/msg/JointState: rad or m; velocities and efforts may be empty.
struct RosJointState {
  RosHeader header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;
};

/// geometry_msgs/msg/PoseStamped: of something in header.frame_id.
struct RosPoseStamped {
  RosHeader header;
  Pose pose;
};

/// geometry_msgs/msg/WrenchStamped: N and N m in header.frame_id.
struct RosWrenchStamped {
  RosHeader header;
  dvec3 force{0.0}, torque{0.0};
};

/// geometry_msgs/msg/TransformStamped: of child_frame_id in header.frame_id.
struct RosTransformStamped {
  RosHeader header;
  std::string child_frame_id;
  Pose transform;
};

/// tf2_msgs/msg/TFMessage.
struct RosTransforms {
  std::vector<RosTransformStamped> transforms;
};

/// sensor_msgs/msg/Joy: the buttons of a stylus.
struct RosJoy {
  RosHeader header;
  std::vector<float> axes;
  std::vector<std::int32_t> buttons;
};

std::string toCdr(const RosJointState& message);
std::string toCdr(const RosPoseStamped& message);
std::string toCdr(const RosWrenchStamped& message);
std::string toCdr(const RosTransforms& message);
std::string toCdr(const RosJoy& message);

/// From CDR; nothing: too short, another representation, lengths that do not fit.
std::optional<RosJointState> jointStateFromCdr(std::string_view bytes);
std::optional<RosPoseStamped> poseStampedFromCdr(std::string_view bytes);
std::optional<RosWrenchStamped> wrenchStampedFromCdr(std::string_view bytes);
std::optional<RosTransforms> transformsFromCdr(std::string_view bytes);
std::optional<RosJoy> joyFromCdr(std::string_view bytes);

/// The definition of a type ("sensor_msgs/msg/JointState") with those that it uses, in the form that MCAP's encoding
/// `ros2msg` asks for. @pre one of the types above
std::string rosDefinition(std::string_view type);

}  // namespace hapticell::exchange
