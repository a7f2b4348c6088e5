// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

class ImportMonitor;

/// How much of a robot's file to read.
enum class RobotContent {
  kAll,
  kKinematics,  ///< Links and joints without their shapes; does not search meshes. For URDF and xacro; others are read
                ///< completely.
};

/// Reads a robot from a URDF file with its meshes (any readable format) and boxes, cylinders, capsules and spheres.
///
/// Joints are in depth-first order of the file, variables from base to tip; mimic chains are resolved to the joint that
/// moves. Meshes are found by findReference() and scaled by their own `scale`; each file is read once. A visual that
/// cannot be read is replaced by the link's collision shapes, and a link without collision shapes is checked with its
/// visual ones; each such case is reported in `diagnostics`. A shape that cannot be loaded is left out, reported and
/// counted in Link::lost_shapes. Floating, planar and spherical joints are read as fixed, with a warning. Dynamics,
/// inertias, efforts, transmissions, calibrations and safety controllers are ignored.
///
/// Errors name file, line, and the fix: those of readUrdfStructure(). Does not throw. Any thread. `monitor` (may be
/// null) gets the progress of reading meshes in the importer's process and can cancel it.
Expected<kinematics::RobotModel> readUrdf(const std::filesystem::path& path, Diagnostics& diagnostics,
                                          ImportMonitor* monitor = nullptr, RobotContent content = RobotContent::kAll);

/// The same from a text, as if it were the content of the file `path` (for messages and relative mesh paths). `places`
/// (may be null): the origin of its lines.
Expected<kinematics::RobotModel> readUrdfText(const std::string& text, const std::filesystem::path& path,
                                              Diagnostics& diagnostics, ImportMonitor* monitor = nullptr,
                                              RobotContent content = RobotContent::kAll,
                                              const std::vector<xacro::Expanded::Place>* places = nullptr);

}  // namespace hapticell::workcell
