// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::trajectory {

/// The state of a hand at one time: the pose of the stylus in the device frame D, and its button.
struct HandSample {
  double t = 0.0;  ///< Seconds.
  Pose X_DS;
  bool button = false;  ///< True while pressed; false if the file does not have this column.
};

/// CSV files with a header line, separated by comma or semicolon, with `.` as decimal point in any locale. Columns are
/// found by name in any order. Other columns, empty lines and lines that begin with `#` are ignored. Errors name the
/// line and column. Numbers must be finite; a quaternion within 1e-3 of unit length is normalised, any other is
/// refused. A file with a header and no rows is an empty list.

/// Columns `x,y,z,qw,qx,qy,qz`: metres and a quaternion, w first.
Expected<std::vector<Pose>> readPoseCsv(const std::filesystem::path& file);

/// Columns `t,x,y,z,qw,qx,qy,qz` and, optionally, `button` (0 or 1). Times increase strictly.
Expected<std::vector<HandSample>> readHandCsv(const std::filesystem::path& file);

/// One column per joint, by name (m, rad). Each row gives the positions in the order of `joint_names`; every joint must
/// have a column.
Expected<std::vector<std::vector<double>>> readJointCsv(const std::filesystem::path& file,
                                                        const std::vector<std::string>& joint_names);

}  // namespace hapticell::trajectory
