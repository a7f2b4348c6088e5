// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

enum class MechanismJointType { kFixed, kRevolute, kPrismatic, kScrew };

/// A body of a mechanism: a solid that was in the cell before it.
struct MechanismPart {
  std::string name;  ///< Unique within the mechanism; the link's name.
  SourceFile source;
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  Pose X_MP;  ///< In the mechanism's frame M while all joints are at 0.
  std::array<float, 3> color{0.72f, 0.74f, 0.76f};
  std::string material = "steel";
};

/// position(of this joint) = ratio * position(of the other) + offset; rad and m.
struct JointCoupling {
  std::string joint;
  double ratio = 1.0;
  double offset = 0.0;
};

/// A joint laid between two parts, on an axis given in the mechanism's frame M while all joints are at 0.
struct MechanismJoint {
  std::string name;
  MechanismJointType type = MechanismJointType::kRevolute;
  std::string parent, child;  ///< Parts. Loops are allowed (a four-bar clamp).
  dvec3 p_MJ{0.0};            ///< A point of the axis.
  dvec3 axis_M{0.0, 0.0, 1.0};
  double lower = 0.0;  ///< rad (revolute, screw) or m; both infinite: no limit.
  double upper = 0.0;
  double velocity = 1.0;  ///< rad/s or m/s.
  double friction = 0.0;  ///< N m or N; how hard it is to move.
  double pitch = 0.0;     ///< Screws: m per turn, right-handed.
  std::optional<JointCoupling> coupling = {};
};

/// A door, a clamp, a gripper, a slide: parts and the joints between them.
struct MechanismDefinition {
  std::vector<MechanismPart> parts;  ///< The first does not move in M.
  std::vector<MechanismJoint> joints;
};

/// Makes the mechanism's model: one link per part, with its name; the first is the root. A screw becomes a turn and a
/// slide that follows it. Where the joints close loops the model gets a kinematics::LoopClosure.
///
/// Errors, each with the joint's or part's name: no parts; empty or duplicate names; a joint between parts that do not
/// exist or from a part to itself; an axis of length zero; reversed limits; a screw without pitch; a coupling to a
/// joint that does not exist, or in a circle; a part that no joint connects to the first.
Expected<kinematics::RobotModel> buildMechanism(const std::string& name, const MechanismDefinition& definition);

/// "fixed", "revolute", "prismatic", "screw".
const char* wordOf(MechanismJointType type);

/// The friction of each variable of the mechanism's model, N m or N, with that of the joints that are coupled to it.
std::vector<double> frictionOf(const MechanismDefinition& definition, const kinematics::RobotModel& model);

}  // namespace hapticell::workcell
