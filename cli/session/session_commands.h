// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

void addFeelCommand(Subcommand app, Action& chosen);
void addRecordCommand(Subcommand app, Action& chosen);
void addSessionCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
