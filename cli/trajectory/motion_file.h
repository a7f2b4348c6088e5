// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/programs/reading/program_reader.h"

namespace hapticell::cli {

/// Forward kinematics of a six-axis robot (a file, or library:NAME), for targets that a program gives by joints: poses
/// of its default tip in its root. Errors: a robot that cannot be read, or does not have six joints.
Expected<trajectory::ProgramReadOptions> programReadOptions(const std::string& robot);

/// Reads a motion from a file in any supported format. `notes` get what was assumed or left out, or standard error if
/// there are no notes. `robot` (may be empty) is for program targets that are given by joints.
Expected<trajectory::Trajectory> readMotionFile(const std::string& file, const std::string& robot = {},
                                                std::vector<Text>* notes = nullptr);

}  // namespace hapticell::cli
