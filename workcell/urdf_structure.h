// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/error.h"

namespace hapticell::workcell {

/// A link or a joint as the file has it, with its line for messages.
struct UrdfElement {
  std::string name;
  int line = 0;
};

struct UrdfJointElement : UrdfElement {
  std::string type;
  std::string parent, child;  ///< Names of links.
};

/// The tree of a URDF file, checked.
struct UrdfStructure {
  std::string robot_name;
  std::string root_link;
  std::vector<UrdfElement> undefined_materials;  ///< Named by a visual, defined nowhere.
  std::vector<UrdfJointElement> joints;          ///< Depth first from the root, in the order of the file.
};

/// Checks the XML of a URDF file and the tree that its links and joints form, before any library sees it.
///
/// Refused, each with line and fix: XML that does not parse, is nested deeper than 200 or holds NUL bytes; a root
/// element other than <robot>; unexpanded xacro; nameless or duplicate links and joints; unknown joint types; a parent,
/// child or mimicked joint that is not there; a link with two parents; two roots; a cycle; a mimic cycle; a revolute or
/// prismatic joint without limits or with lower over upper; an axis of length zero; a number that is none. `file`
/// stands in the messages only.
Expected<UrdfStructure> checkUrdfStructure(const std::string& content, const std::string& file);

}  // namespace hapticell::workcell
