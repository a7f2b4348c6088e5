// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"
#include "config/user_folders.h"

int main(int argc, char** argv) {
  hapticell::config::cleanEnvironment();
  return hapticell::cli::runCommandLine(argc, argv);
}
