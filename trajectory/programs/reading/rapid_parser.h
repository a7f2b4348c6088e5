// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trajectory/programs/reading/program_run.h"

namespace hapticell::trajectory {

const Dialect& rapid();

/// The routines of RAPID modules and, as statements, the data declared outside of them. Record definitions and error
/// handlers of routines are skipped. A block without an end makes the path fail with the line of the block.
void parseRapid(const Tokens& tokens, ProgramPath& path, std::vector<Routine>& routines, Block& data);

}  // namespace hapticell::trajectory
