// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

void addErgonomicsCommand(Subcommand app, Action& chosen);

/// Adds `posture`, `en1005`, `iso11226`, `eaws` and `workplace` below `ergonomics`.
void addErgonomicsPostureCommands(Subcommand ergonomics, Action& chosen);

}  // namespace hapticell::cli
