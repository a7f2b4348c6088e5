// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/programs/reading/program_reader.h"

namespace hapticell::cli {

/// The poses of a six-axis robot (a file, or library:NAME) for targets that a program gives by joints: of its default
/// tip in its root. Errors: a robot that cannot be read, or has other than six joints.
Expected<trajectory::ProgramReadOptions> programReadOptions(const std::string& robot);

/// Reads a motion from any file that motions are read from. What was assumed or left out goes to `notes`, or to
/// standard error if there are no notes. `robot` (may be empty) is for targets of programs that are given by joints.
Expected<trajectory::Trajectory> readMotionFile(const std::string& file, const std::string& robot = {},
                                                std::vector<Text>* notes = nullptr);

}  // namespace hapticell::cli
