// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/kit/command_listener.h"

namespace hapticell::cli {

/// Reads the command line and runs the chosen command. Never throws; main() does nothing else.
int runCommandLine(int argc, char** argv);

/// The same for another program: `words` without the program's name. All that the command says goes to `listener`, in
/// this thread, except progress. Returns the exit status, 0 to 2. Signals and the locale are left alone. Never throws.
/// Any thread; several commands may run at the same time, except in one working folder that they write to.
int runCommand(const std::vector<std::string>& words, CommandListener& listener);

/// All commands with their options: see grammarOf().
nlohmann::ordered_json commandGrammar();

}  // namespace hapticell::cli
