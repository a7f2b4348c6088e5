// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::trajectory {

/// What a hand does at one moment: the pose of the stylus in the device's frame D, and its button.
struct HandSample {
  double t = 0.0;  ///< Seconds.
  Pose X_DS;
  bool button = false;  ///< Pressed; false if the file does not have this column.
};

/// CSV files with a header line, comma or semicolon between fields, `.` as decimal point whatever the locale. Columns
/// are found by name in any order; further columns are passed over, so are empty lines and lines that begin with `#`.
/// Errors name line and column. Numbers must be finite; a quaternion within 1e-3 of unit length is normalised, any
/// other is refused. A file with a header and no rows is an empty list.

/// Columns `x,y,z,qw,qx,qy,qz`: metres and a quaternion, w first.
Expected<std::vector<Pose>> readPoseCsv(const std::filesystem::path& file);

/// Columns `t,x,y,z,qw,qx,qy,qz` and, where there is one, `button` (0 or 1). Times increase strictly.
Expected<std::vector<HandSample>> readHandCsv(const std::filesystem::path& file);

/// One column a joint, by name (m, rad). Each row gives the positions in the order of `joint_names`; all of them must
/// have a column.
Expected<std::vector<std::vector<double>>> readJointCsv(const std::filesystem::path& file,
                                                        const std::vector<std::string>& joint_names);

}  // namespace hapticell::trajectory
