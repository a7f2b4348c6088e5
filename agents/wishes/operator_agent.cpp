// SPDX-License-Identifier: Apache-2.0
#include "agents/wishes/operator_agent.h"

#include "agents/body/follow.h"
#include "agents/task/section_reader.h"
#include "agents/wishes/agent_makers.h"
#include "agents/wishes/simulated_hand.h"

namespace hapticell::agents {

OperatorAgent::OperatorAgent() = default;
OperatorAgent::OperatorAgent(std::unique_ptr<SimulatedHand> hand) : hand_(std::move(hand)) {}
OperatorAgent::~OperatorAgent() = default;

void OperatorAgent::wish(const AgentView& view, Wish& wish) {
  if (hand_ && view.way != nullptr) {
    // Who has handed over lets the planner lead: pulling on at three times its weight is what nothing came of.
    hand_->beLed();
    hand_velocity_.reset();
    return;
  }
  if (hand_) hand_velocity_ = hand_->velocity(view);
  if (!hand_velocity_) return;
  const bool with_turn = view.goal.q_WG.has_value() || view.body.figure() == nullptr;
  wish.p_W = view.body.handle().p;
  wish.v = follow(view.body, {view.body.handleLink(), wish.p_W, *hand_velocity_, with_turn});
  wish.arrow_W = hand_velocity_->linear;
}

bool OperatorAgent::onDeadlock(const AgentView& view) {
  if (hand_) hand_->drawBack(view);
  return hand_ != nullptr || hand_velocity_.has_value();
}

MadeAgent makeOperatorAgent(const AgentMaking& making) {
  auto hand = std::make_unique<SimulatedHand>(making.seed);
  SectionReader reader(making.section);
  reader.fields().read("speed", hand->speed, 1.0, 0.01, 3.0);
  reader.fields().read("turn_speed", hand->turn_speed, kDegree, 1.0, 360.0);
  reader.fields().read("ball", hand->ball, 1.0, 0.01, 0.5);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<OperatorAgent>(std::move(hand));
}

}  // namespace hapticell::agents
