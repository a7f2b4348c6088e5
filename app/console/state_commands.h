// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/command.h"

namespace hapticell::app {

/// Commands that lead from one state of a cell to another; entities are the same if their names are, or if one is gone
/// and a single new one has its shape (then it was renamed). The commands are tried on a copy, and the text of what comes
/// of them is compared with that of `wanted`, numbers within 1e-9. Error: no such commands were found. Any thread.
Expected<std::vector<workcell::Command>> commandsBetween(const workcell::DocumentState& now,
                                                         const workcell::DocumentState& wanted);

}  // namespace hapticell::app
