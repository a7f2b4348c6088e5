// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/follow.h"
#include "agents/task/section_reader.h"
#include "agents/wishes/agent_makers.h"

namespace hapticell::agents {

namespace {

/// m^2: lets a point that hardly any variable moves stay where it is. Half: joints hurry for little; twice: gives way
/// less.
constexpr double kStiffPoint = 0.01;

/// m before the goal where repulsion begins to fade, so that a goal beside an obstacle is reached (Ge and Cui, "New
/// potential functions for mobile robot path planning", 2000). Half: runs stop short of such goals; twice: hardly any
/// repulsion in small cells.
constexpr double kFade = 0.15;
/// Share of the repulsion on the planner's way, which keeps the clearance by itself. Half: no change seen; twice:
/// pushed off the way in narrow places.
constexpr double kFadeOnWay = 0.2;

/// Repulsion: the nearest point of each near pair moves straight away from it, the faster the nearer (a potential field,
/// Khatib 1986, over exact distances).
class ObstacleAgent final : public Agent {
 public:
  double within = 0.08, speed = 0.25;  // m, m/s

  void wish(const AgentView& view, Wish& wish) override {
    const MovedBody& body = view.body;
    const auto screws = body.screws();
    std::vector<double> column(body.size()), sum(body.size(), 0.0);
    double fade = std::min(1.0, glm::length(view.goal.p_WG - body.handle().p) / kFade);
    if (view.way != nullptr) fade = std::min(fade, kFadeOnWay);
    double shares = 0.0;
    for (const NearPair& pair : view.near) {
      if (pair.distance >= within || pair.other_link >= 0) continue;
      double squares = kStiffPoint;
      for (std::size_t v = 0; v < body.size(); ++v) {
        const bool moves = body.speed(v) > 0.0 && body.carries(v, pair.link);
        column[v] = moves ? glm::dot(pair.nhat_W, screws[v].at(pair.p_WA)) : 0.0;
        squares += column[v] * column[v];
      }
      const double share = 1.0 - pair.distance / within;
      const double away = fade * speed * share * share;
      shares += share;
      for (std::size_t v = 0; v < body.size(); ++v) sum[v] += share * away * column[v] / squares;
      if (away > glm::length(wish.arrow_W)) {
        wish.p_W = pair.p_WA;
        wish.arrow_W = away * pair.nhat_W;
      }
    }
    if (shares <= 0.0) return;
    // The mean, not the sum: a hand with its fingers near a wall is pushed no harder than a fist.
    wish.v = std::move(sum);
    for (double& v : wish.v) v /= shares;
  }
};

}  // namespace

MadeAgent makeObstacleAgent(const AgentMaking& making) {
  auto agent = std::make_unique<ObstacleAgent>();
  SectionReader reader(making.section);
  reader.fields().read("within", agent->within, 1.0, 0.001, kLook);
  reader.fields().read("speed", agent->speed, 1.0, 0.01, 3.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
