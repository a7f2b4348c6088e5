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

/// What a robot's program is read with.
struct ProgramReadOptions {
  /// The TCP in the robot's base at six joints (rad), for targets given by joints; where not set, such targets at the
  /// begin or the end of a motion are left out with a note, others are an error.
  std::function<std::optional<Pose>(std::span<const double>)> forward_kinematics{};
  std::vector<std::string> joint_names{};  ///< Of that robot.
};

/// A program as a motion: a frame a target, arcs as frames within 0.1 mm of the arc.
struct ReadProgram {
  Trajectory trajectory;
  std::vector<Text> notes;  ///< What was assumed, left out or not understood, with its lines.
};

/// True for .src, .dat (KUKA KRL), .mod, .modx, .prg, .sys (ABB RAPID), .ls (FANUC), .script, .urscript (URScript)
/// and .jbi (Motoman INFORM).
bool isProgramFile(const std::filesystem::path& file);

/// Reads a program of KRL (points of the .dat beside it, and of a $config.dat there), RAPID, FANUC LS, URScript or
/// INFORM.
///
/// Runs its main routine: variables, arithmetic, loops, branches and routines of the file count as far as the file says
/// their values. What depends on something else (inputs, sensors, other files) is reported; a branch of unknown
/// condition with moves in it, a jump, or a target in the middle that is not known, is an error with its line. Poses
/// are of the TCP in the robot's base where the file gives the base, work object or user frame, else in that. Times are
/// length by speed: a program has none.
Expected<ReadProgram> readProgram(const std::filesystem::path& file, const ProgramReadOptions& options = {});

}  // namespace hapticell::trajectory
