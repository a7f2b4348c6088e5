// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

/// access: whether a part can be taken out, in which order, and who reaches and sees it.
void addAccessCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
