// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

void addWorkcellCommand(Subcommand app, Action& chosen);

/// Adds `workcell pack` and `workcell changes`, below `workcell`.
void addWorkcellExchangeCommands(Subcommand workcell, Action& chosen);

}  // namespace hapticell::cli
