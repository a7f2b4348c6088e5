// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

inline constexpr double kTurn = 2.0 * std::numbers::pi;  ///< rad.

/// Shifts turning variables by whole turns to where they are nearest to `x_start` within their limits, and puts what is
/// over a limit by less than 1e-9 on it; false when one is outside its limits whatever the turn.
bool takeNearestTurns(const Chain& chain, const ChainPositions& x_start, ChainPositions& x);

/// True when no variable differs by more than `tolerance` (rad or m), full turns left out of account.
bool sameButForTurns(const Chain& chain, const ChainPositions& a, const ChainPositions& b, double tolerance);

/// Sum of the squared differences.
double distanceSquared(const Chain& chain, const ChainPositions& a, const ChainPositions& b);

}  // namespace hapticell::kinematics
