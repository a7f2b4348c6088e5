// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "agents/wishes/agent.h"
#include "agents/wishes/seeded_numbers.h"

namespace hapticell::agents {

/// A person who leads the moved frame by hand, for runs without one (docs/user/agents.md describes it).
///
/// It sees the cell and where the moved frame is, but not how near the rest of the entity comes to anything. Twice a
/// second it looks whether a ball goes straight to the goal; if not, it chooses the shortest way over one point beside
/// it, as it judges lengths (wrong by up to 15 %). It points a few degrees off, and its hand drifts. When
/// nothing moves, it draws back for a moment and chooses another way. A seed decides all its mistakes.
class SimulatedHand {
 public:
  explicit SimulatedHand(std::uint64_t seed) : random_(seed) {}

  double speed = 0.25;       ///< m/s of its hand.
  double turn_speed = 0.8;   ///< rad/s
  double ball = 0.06;        ///< m, radius of the ball for which it wants room.

  /// The motion that it wants of the moved frame now.
  Twist velocity(const AgentView& view);
  /// Nothing moves: it chooses another way.
  void drawBack(const AgentView& view);
  /// Something else leads: afterwards it looks again and chooses from where it then is.
  void beLed();

 private:
  void choose(const AgentView& view);
  double judged(double length) { return length * (1.0 + random_.within(0.15)); }

  SeededNumbers random_;
  std::optional<dvec3> over_;  ///< The point beside the straight way that it goes to first.
  std::vector<dvec3> tried_;   ///< Points that led to nothing.
  dvec3 back_{0.0};            ///< Where it draws back to,
  double back_until_ = -1.0;   ///< and until when, s.
  double looked_at_ = -1.0;
  dvec3 drift_{0.0}, off_{0.0};
};

}  // namespace hapticell::agents
