// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/subcommand.h"
#include "workcell/entity/import_options.h"

namespace hapticell::cli {

/// Adds --chord METRES and --angle RADIANS: how finely the curved faces of STEP and IGES are meshed.
void addTessellationOptions(Subcommand command, workcell::Tessellation& tessellation);

}  // namespace hapticell::cli
