// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/follow.h"
#include "agents/task/section_reader.h"
#include "agents/wishes/agent_makers.h"

namespace hapticell::agents {

namespace {

/// 1/s: the last stretch takes this share of the way a second. Half: arrives twice as slowly; twice: brakes late.
constexpr double kApproach = 3.0;

dvec3 atMost(const dvec3& v, double most) {
  const double length = glm::length(v);
  return length > most ? (most / length) * v : v;
}

/// Attraction: the moved frame goes straight to the goal, or along the planner's way where one is followed.
class GoalAgent final : public Agent {
 public:
  double speed = 0.25, turn_speed = 0.8;  // m/s, rad/s

  void wish(const AgentView& view, Wish& wish) override {
    const Pose& X_WM = view.body.handle();
    if (view.way != nullptr) {
      wish.v = view.way->velocities(view.body, speed, turn_speed);
      wish.p_W = X_WM.p;
      wish.arrow_W = velocityOf(view.body, view.body.handleLink(), X_WM.p, wish.v);
      return;
    }
    PointWish to{view.body.handleLink(), X_WM.p, {}, view.goal.q_WG.has_value()};
    to.velocity.linear = atMost(kApproach * (view.goal.p_WG - X_WM.p), speed);
    if (view.goal.q_WG)
      to.velocity.angular = atMost(kApproach * difference(Pose{X_WM.p, *view.goal.q_WG}, X_WM).angular, turn_speed);
    wish.v = follow(view.body, to);
    wish.p_W = X_WM.p;
    wish.arrow_W = to.velocity.linear;
  }
};

}  // namespace

MadeAgent makeGoalAgent(const AgentMaking& making) {
  auto agent = std::make_unique<GoalAgent>();
  SectionReader reader(making.section);
  reader.fields().read("speed", agent->speed, 1.0, 0.01, 3.0);
  reader.fields().read("turn_speed", agent->turn_speed, kDegree, 1.0, 360.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
