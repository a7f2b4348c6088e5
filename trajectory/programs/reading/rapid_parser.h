// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trajectory/programs/reading/program_run.h"

namespace hapticell::trajectory {

const Dialect& rapid();

/// The routines of RAPID modules and, as statements, the data declared outside of them. Records, and handlers of errors
/// in routines, are passed over. A block that does not end fails the path with its line.
void parseRapid(const Tokens& tokens, ProgramPath& path, std::vector<Routine>& routines, Block& data);

}  // namespace hapticell::trajectory
