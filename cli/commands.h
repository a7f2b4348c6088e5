// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "cli/result_writer.h"
#include "cli/subcommand.h"

namespace hapticell::cli {

/// How a command ends: the process's exit status (docs/command-line.md).
enum class ExitStatus {
  kDone = 0,
  kCheckFound = 1,  ///< A check that was asked for found something.
  kBadInput = 2,    ///< Bad usage or bad input; a sentence went to standard error.
};

/// What a chosen command runs once the command line was read: it writes one result and tells how it ended.
using Action = std::function<ExitStatus(ResultWriter&)>;

/// Each command lives in a file of its own and adds itself as a sub-command: its options, and (by a callback that is
/// called when the user chose it) the action, put into `chosen`. Nothing heavy happens while options are read.
void addConvertCommand(Subcommand app, Action& chosen);
void addInspectCommand(Subcommand app, Action& chosen);
void addDevicesCommand(Subcommand app, Action& chosen);
void addDistanceCommand(Subcommand app, Action& chosen);
void addErgonomicsCommand(Subcommand app, Action& chosen);
void addErgonomicsPostureCommands(Subcommand ergonomics, Action& chosen);  ///< Into the ergonomics command.
void addFeelCommand(Subcommand app, Action& chosen);
void addForwardKinematicsCommand(Subcommand app, Action& chosen);
void addInverseKinematicsCommand(Subcommand app, Action& chosen);
void addLibraryCommand(Subcommand app, Action& chosen);
void addTrajectoryCommand(Subcommand app, Action& chosen);
void addPairCommand(Subcommand app, Action& chosen);
void addMannequinCommand(Subcommand app, Action& chosen);
void addWorkcellCommand(Subcommand app, Action& chosen);
void addSessionCommand(Subcommand app, Action& chosen);

/// `workcell pack` and `workcell changes`, below `workcell`.
void addWorkcellExchangeCommands(Subcommand workcell, Action& chosen);

/// Reads the command line and runs the chosen command. Never throws; this is all of main().
int runCommandLine(int argc, char** argv);

}  // namespace hapticell::cli
