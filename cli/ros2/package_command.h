// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

struct PackageWords {
  std::string workcell, entity, output;
  int samples = 100'000;
};

/// Writes a robot of a cell as a ROS 2 package in a new folder: URDF with meshes, SRDF with groups, poses and pairs
/// that need no check, joint limits, a launch file. The package is read back by the program's own reader and compared
/// before the folder gets its name. Result: `package`, `links`, `joints`, `pairs{}` by reason. Errors: no such robot, a
/// folder that is not empty, a package that does not come back equal.
Expected<nlohmann::ordered_json> writeRosPackage(const PackageWords& words);

}  // namespace hapticell::cli
