// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/action.h"
#include "cli/subcommand.h"

namespace hapticell::cli {

void addFeelCommand(Subcommand app, Action& chosen);
void addSessionCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
