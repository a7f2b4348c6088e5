// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

void addPlanCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
