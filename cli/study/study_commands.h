// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

/// study run, show, best, export, open, merge and submit.
void addStudyCommand(Subcommand app, Action& chosen);

/// study submit, below `study`.
void addStudySubmit(Subcommand study, Action& chosen);

}  // namespace hapticell::cli
