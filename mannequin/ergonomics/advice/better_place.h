// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/scores/method_score.h"

namespace hapticell::ergonomics {

/// How the work would have to be moved for a lower level by a method.
struct BetterPlace {
  dvec3 shift_W{0.0};  ///< m, of all active hands' targets.
  MethodScore score;   ///< There.
  mannequin::Posture posture;
};

/// One for each of kPostureMethods.
using BetterPlaces = std::array<std::optional<BetterPlace>, kPostureMethods.size()>;

/// For each method the smallest shift of the targets (down, up, nearer, further, to a side; up to 0.6 m in steps of
/// 10 mm) with which the figure, within its limits and in balance, comes to a lower level of that method; nothing where
/// none does, or where the level is the least already. Up to some hundred milliseconds: not for Qt's thread.
BetterPlaces betterPlaces(const mannequin::Figure& figure, const mannequin::Posture& posture, const WorkTask& task);

/// The same for one method, as far as it needs to look.
std::optional<BetterPlace> betterPlace(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                       const WorkTask& task, PostureMethod method = PostureMethod::kRula);

}  // namespace hapticell::ergonomics
