// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/kit/action.h"
#include "cli/kit/subcommand.h"

namespace hapticell::cli {

void addForwardKinematicsCommand(Subcommand app, Action& chosen);
void addInverseKinematicsCommand(Subcommand app, Action& chosen);
void addLibraryCommand(Subcommand app, Action& chosen);

}  // namespace hapticell::cli
