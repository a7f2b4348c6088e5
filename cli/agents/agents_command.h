// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

/// agents TASK: seeded runs, and the recording of one.
void addAgentsCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
