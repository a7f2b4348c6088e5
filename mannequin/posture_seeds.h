// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body_solver.h"

namespace hapticell::mannequin {

/// Starting postures for a cold solve, best first.
struct Seeds {
  static constexpr std::size_t kMost = 14;
  std::array<BodyState, kMost> states{};
  std::size_t count = 0;
};

/// A state with arms in closed form at the best of some swivels; the cost is 10 times what exceeds limits (rad) and a
/// little for swivels that people avoid.
struct SeededState {
  BodyState state;
  double cost = 0.0;
};
SeededState withArms(const Figure& figure, const ResolvedTask& task, const BodyState& from, int swivels);

/// 48 trunks built from the present stance (4 crouches, 4 pitches, 3 turns), legs in closed form, ranked by how well
/// the shoulders then stand to the hands' targets; the best ones with arms.
Seeds makeSeeds(const Figure& figure, const ResolvedTask& task, const BodyState& present);

/// The whole figure with its feet moved and turned so that what the hands want lies well before it.
Posture steppedTowards(const Figure& figure, const PostureTask& task, const Posture& start);

}  // namespace hapticell::mannequin
