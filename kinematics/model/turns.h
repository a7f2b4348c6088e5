// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

inline constexpr double kTurn = 2.0 * std::numbers::pi;  ///< rad.

/// Shifts turning variables by full turns to the position nearest to `x_start` within their limits, and moves what
/// exceeds a limit by less than 1e-9 onto it; false if a variable is outside its limits at every turn.
bool takeNearestTurns(const Chain& chain, const ChainPositions& x_start, ChainPositions& x);

/// True if no variable differs by more than `tolerance` (rad or m), apart from full turns.
bool sameButForTurns(const Chain& chain, const ChainPositions& a, const ChainPositions& b, double tolerance);

/// Sum of the squared differences.
double distanceSquared(const Chain& chain, const ChainPositions& a, const ChainPositions& b);

}  // namespace hapticell::kinematics
