// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "workcell/document/document.h"

namespace hapticell::app {

/// What the robot stands on that can go along with its tool (a rail, a table that turns), the lowest first: not what is
/// locked, or has closed loops. They live as long as the state. Any thread.
std::vector<const workcell::Entity*> externalAxes(const workcell::DocumentState& state, const workcell::Entity& robot);

}  // namespace hapticell::app
