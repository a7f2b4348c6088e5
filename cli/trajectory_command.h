// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/action.h"
#include "cli/subcommand.h"

namespace hapticell::cli {

void addTrajectoryCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
