// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/posture/body_solver.h"

namespace hapticell::mannequin {

/// A state with arms in closed form at the best of several swivels; the cost is 10 times the excess over limits (rad)
/// plus a small cost for uncommon swivels.
struct SeededState {
  BodyState state;
  double cost = 0.0;
};
SeededState withArms(const Figure& figure, const ResolvedTask& task, const BodyState& from, int swivels);

/// Starting postures for a cold solve: 48 trunks built from the present stance (4 crouches, 4 pitches, 3 turns), ranked
/// by the position of the shoulders relative to the hands' targets. The best are made into whole postures, legs and
/// arms in closed form, a few at a time when they are asked for.
class PostureSeeds {
 public:
  /// Trunks of the lattice (4 crouches, 4 pitches, 3 turns), tries for two hands and for one; found by trial. Half:
  /// more reachable targets are missed; twice: up to twice the time for those out of reach.
  static constexpr std::size_t kTrunks = 48, kMost = 8, kBatch = 4;

  PostureSeeds(const Figure& figure, const ResolvedTask& task, const BodyState& present);
  /// The next state to try; nullptr after kMost, or after the first batch if only one hand has a target.
  const BodyState* next();

 private:
  struct Ranked {
    double cost;
    std::size_t index;
  };
  void makeBatch();

  const Figure& figure_;
  const ResolvedTask& task_;
  const BodyState& present_;
  std::array<Ranked, kTrunks> ranked_{};
  std::array<BodyState, kBatch> batch_;
  std::array<std::size_t, kBatch> order_{};
  std::size_t given_ = 0;
};

/// The whole figure with its feet moved and turned so that the targets of the hands lie well in front of it.
Posture steppedTowards(const Figure& figure, const PostureTask& task, const Posture& start);

}  // namespace hapticell::mannequin
