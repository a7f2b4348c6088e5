// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "cli/result_writer.h"

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
void addConvertCommand(CLI::App& app, Action& chosen);
void addInspectCommand(CLI::App& app, Action& chosen);
void addDevicesCommand(CLI::App& app, Action& chosen);
void addDistanceCommand(CLI::App& app, Action& chosen);
void addErgonomicsCommand(CLI::App& app, Action& chosen);
void addErgonomicsPostureCommands(CLI::App& ergonomics, Action& chosen);  ///< Into the ergonomics command.
void addFeelCommand(CLI::App& app, Action& chosen);
void addForwardKinematicsCommand(CLI::App& app, Action& chosen);
void addInverseKinematicsCommand(CLI::App& app, Action& chosen);
void addLibraryCommand(CLI::App& app, Action& chosen);
void addTrajectoryCommand(CLI::App& app, Action& chosen);
void addPairCommand(CLI::App& app, Action& chosen);
void addMannequinCommand(CLI::App& app, Action& chosen);
void addWorkcellCommand(CLI::App& app, Action& chosen);
void addSessionCommand(CLI::App& app, Action& chosen);

/// `workcell pack` and `workcell changes`, below `workcell`.
void addWorkcellExchangeCommands(CLI::App& workcell, Action& chosen);

/// Reads the command line and runs the chosen command. Never throws; this is all of main().
int runCommandLine(int argc, char** argv);

}  // namespace hapticell::cli
