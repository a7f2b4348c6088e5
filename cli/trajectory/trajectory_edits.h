// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

/// Writes a trajectory as .csv, .htraj or .json; does nothing for an empty path. Error: other extensions.
Expected<void> saveTrajectory(const trajectory::Trajectory& trajectory, const std::string& path);

/// Writes a command's result, or reports the error; 1 if its field "found" is true.
ExitStatus finishTrajectory(const ResultWriter& writer, const Expected<nlohmann::ordered_json>& result);

/// Adds "trim", "split", "join", "reverse", "mirror", "insert", "move", "delete", "dwell", "approach", "retract" and
/// "resample" below `trajectory`: each makes a copy.
void addTrajectoryEdits(Subcommand command, Action& chosen);

/// Adds "curves", "score", "train" and "exercises" below `trajectory`.
void addTrajectoryTraining(Subcommand command, Action& chosen);

}  // namespace hapticell::cli
