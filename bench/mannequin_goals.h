// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <random>

#include "mannequin/posture/posture_solver.h"

namespace hapticell::bench {

/// A goal that is reachable because a posture is known that reaches it.
struct ReachableGoal {
  mannequin::PostureTask task;
  mannequin::Posture reached;
  mannequin::Posture neutral;  ///< The start of a cold solve: standing on the same feet.
};

struct GoalOptions {
  double share = 1.0;         ///< Of all joint ranges.
  bool split_stance = false;  ///< Feet 30 cm apart lengthwise, toes 12 and 15 deg out; else parallel.
};

/// Random posture uniform in the limits (elbow over 12 deg), the pelvis crouched down to 0.5 m and pitched -15..60 deg,
/// legs put back by their closed form; drawn again until legs, balance and a coarse self-clearance hold.
ReachableGoal makeGoal(const mannequin::Figure& figure, const GoalOptions& options, std::mt19937_64& random);

}  // namespace hapticell::bench
