// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

class TiXmlElement;

namespace hapticell::workcell {

class UrdfLines;

/// A <visual> or <collision>.
struct UrdfShape {
  enum class Kind { kNone, kEmpty, kBox, kCylinder, kSphere, kCapsule, kMesh };
  Kind kind = Kind::kNone;  ///< kNone: not supported, see `reason`. kEmpty: a placeholder without size.
  Text reason;
  dvec3 size{1.0};  ///< Edges of a box; scale of a mesh.
  double radius = 0.0, length = 0.0;
  std::string mesh;  ///< As named in the file.
  Pose X_LS;
  std::string material;  ///< Empty: no name.
  std::optional<std::array<float, 4>> color;
  int line = 0;
};

struct UrdfLink {
  std::string name;
  int line = 0;
  std::vector<UrdfShape> visuals, collisions;
};

struct UrdfJoint {
  kinematics::Joint joint;  ///< Without links, variable and mimic.
  std::string type;         ///< As in the file.
  std::string parent, child;
  std::string mimicked;  ///< Empty: it moves independently.
  double multiplier = 1.0, offset = 0.0;
  bool states_velocity = true;
  int line = 0, mimic_line = 0;
};

/// A <material>: its colour, or what it has instead.
struct UrdfMaterial {
  std::string name;
  std::optional<std::array<float, 4>> color;
  bool textured = false;
  int line = 0;
};

/// Reads the elements of a URDF file. Only what affects joints or shapes can be an error; other unusual values give a
/// warning. Errors have the line: origins, axes, limits and mimics that are not numbers, a zero axis, a joint of
/// unknown type, without name or ends. Limits that are infinite, crossed or missing mean no limit (as in PyBullet);
/// each gives a warning, except for "inf" itself.
Expected<UrdfLink> readUrdfLink(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics);
Expected<UrdfJoint> readUrdfJoint(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics);
UrdfMaterial readUrdfMaterial(const TiXmlElement& element, const UrdfLines& lines, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
