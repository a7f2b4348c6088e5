// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

/// live: shows a cell, a motion and the stylus of a running server to viewers in a browser.
void addLiveCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
