// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::cli {

/// Reads the command line and runs the chosen command. Never throws; main() does nothing else.
int runCommandLine(int argc, char** argv);

}  // namespace hapticell::cli
