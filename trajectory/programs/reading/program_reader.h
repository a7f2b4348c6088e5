// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Information about the robot for reading its program.
struct ProgramReadOptions {
  /// Returns the TCP in the robot's base for six joints (rad), for targets given by joints. If not set, such targets
  /// are left out at the start or the end of a motion, and are an error elsewhere.
  std::function<std::optional<Pose>(std::span<const double>)> forward_kinematics{};
  std::vector<std::string> joint_names{};  ///< Of that robot.
};

/// A program as a motion: one frame per target, arcs as frames within 0.1 mm of the arc.
struct ReadProgram {
  Trajectory trajectory;
  std::vector<Text> notes;  ///< What was assumed, left out or not understood, with line numbers.
};

/// True for .src, .dat (KUKA KRL), .mod, .modx, .prg, .sys (ABB RAPID), .ls (FANUC), .script, .urscript (URScript)
/// and .jbi (Motoman INFORM).
bool isProgramFile(const std::filesystem::path& file);

/// Reads a program of KRL (with the points of the .dat beside it, and of a $config.dat in the folder), RAPID, FANUC LS,
/// URScript or INFORM.
///
/// Runs its main routine: variables, arithmetic, loops, branches and routines of the file are used as far as the file
/// defines their values. What depends on something else (inputs, sensors, other files) is reported. A branch with moves
/// and an unknown condition, a jump, or an unknown target in the middle is an error with its line. Poses are of the TCP
/// in the robot's base if the file gives the base, work object or user frame, otherwise in that frame. Times are length
/// divided by speed: a program has none.
Expected<ReadProgram> readProgram(const std::filesystem::path& file, const ProgramReadOptions& options = {});

}  // namespace hapticell::trajectory
