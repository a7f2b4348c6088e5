// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/scores/method_score.h"

namespace hapticell::ergonomics {

/// The shift of the work that gives a lower level by a method.
struct BetterPlace {
  dvec3 shift_W{0.0};  ///< m, of the targets of all active hands.
  MethodScore score;   ///< At the shifted place.
  mannequin::Posture posture;
};

/// One for each of kPostureMethods.
using BetterPlaces = std::array<std::optional<BetterPlace>, kPostureMethods.size()>;

/// For each method the smallest shift of the targets (down, up, nearer, further, to a side; up to 0.6 m in steps of 10
/// mm) at which the figure, within its limits and in balance, has a lower level by that method; empty if no shift gives
/// one, or if the level is already the least. Takes up to some hundred milliseconds: do not call from the GUI thread.
BetterPlaces betterPlaces(const mannequin::Figure& figure, const mannequin::Posture& posture, const WorkTask& task);

/// The same for one method; the search ends as soon as the answer is known.
std::optional<BetterPlace> betterPlace(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                       const WorkTask& task, PostureMethod method = PostureMethod::kRula);

}  // namespace hapticell::ergonomics
