// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/robots/robot_toml.h"

namespace hapticell::workcell {

/// A robot of the shipped library: "library:NAME" loads it.
struct LibraryRobot {
  std::string name;
  RobotSheet sheet;
  std::filesystem::path file;  ///< robots/NAME.toml, or robots/NAME/robot.toml or robot.urdf.
};

/// All built-in robots, by name. Files that cannot be read are reported in `diagnostics` and left out.
std::vector<LibraryRobot> listLibraryRobots(Diagnostics& diagnostics);

/// The file of a library robot; if the name is unknown, an error that lists some names.
Expected<std::filesystem::path> findLibraryRobot(const std::string& name);

/// Payload, kg, of a robot with that SourceFile::path, from its robot.toml, built-in or the user's own. 0 if no payload
/// is stated (URDF, SDF, mechanisms). Error: the file is missing or broken.
Expected<double> ratedPayload(const std::string& source);

}  // namespace hapticell::workcell
