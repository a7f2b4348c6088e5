// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "agents/wishes/agent.h"

namespace hapticell::agents {

class SimulatedHand;

/// The operator among the agents: the motion of a hand, of a person at the stylus or of a simulated one. The simulated
/// one wishes nothing while a planner's way is followed.
class OperatorAgent final : public Agent {
 public:
  /// Without a hand: moves nothing until setHand().
  OperatorAgent();
  explicit OperatorAgent(std::unique_ptr<SimulatedHand> hand);
  ~OperatorAgent() override;

  /// The motion that a person's hand wants of the moved frame (m/s, rad/s); it stays until the next call. Empty: the
  /// hand is away.
  void setHand(const std::optional<Twist>& velocity) { hand_velocity_ = velocity; }

  void wish(const AgentView& view, Wish& wish) override;
  bool onDeadlock(const AgentView& view) override;

 private:
  std::unique_ptr<SimulatedHand> hand_;
  std::optional<Twist> hand_velocity_;
};

}  // namespace hapticell::agents
