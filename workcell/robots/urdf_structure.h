// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/robots/urdf_elements.h"

namespace hapticell::workcell {

class UrdfLines;

/// A URDF file, read and checked.
struct UrdfStructure {
  std::string robot_name;  ///< Empty: the file gives no name.
  std::string root_link;
  std::vector<UrdfLink> links;    ///< In the order of the file.
  std::vector<UrdfJoint> joints;  ///< Depth first from the root, in the order of the file.

  const UrdfLink& link(const std::string& name) const;
};

/// Reads the XML of a URDF file: links with the colours of their materials, and the tree of its joints.
///
/// Errors, each with line and fix: those of xacro::parseXml(); a root element other than <robot>; unexpanded xacro;
/// links and joints without a name or with the same name; those of readUrdfJoint(); a parent, child or mimicked joint
/// that does not exist; a link with two parents; two roots, unless all but one have neither joints nor shapes (these
/// are left out and reported); a cycle; a mimic cycle. `lines` gives the origin of the text.
Expected<UrdfStructure> readUrdfStructure(const std::string& content, const UrdfLines& lines, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
