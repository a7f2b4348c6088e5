// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trajectory/programs/reading/program_run.h"

namespace hapticell::trajectory {

const Dialect& krl();

/// The routines of a KRL module (.src) and, as statements, the lines outside of them (.dat). A block without an end
/// makes the path fail with the line of the block.
void parseKrl(const Tokens& tokens, ProgramPath& path, std::vector<Routine>& routines, Block& data);

}  // namespace hapticell::trajectory
