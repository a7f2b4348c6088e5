// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "agents/body/follow.h"
#include "agents/task/section_reader.h"
#include "agents/wishes/agent_makers.h"

namespace hapticell::agents {

namespace {

/// Of a variable, for the slope of the least singular value. Half, twice: far above rounding, far below its bends.
constexpr double kProbe = 1e-3;

/// Keeps joints away from their limits, and a robot with six joints and more away from singular places.
class LimitAgent final : public Agent {
 public:
  double zone = 10.0 * kDegree;  // rad or m before a limit
  double singular = 0.08;        // least singular value that is kept

  void wish(const AgentView& view, Wish& wish) override {
    const MovedBody& body = view.body;
    wish.v.assign(body.size(), 0.0);
    for (std::size_t v = 0; v < body.size(); ++v) {
      const Room room = body.room(v);
      // Of a narrow range no more than a quarter from each end.
      const double near = std::min(zone, 0.25 * (room.down + room.up));
      if (near <= 0.0) continue;
      const double up = std::clamp(1.0 - room.down / near, 0.0, 1.0);
      const double down = std::clamp(1.0 - room.up / near, 0.0, 1.0);
      wish.v[v] = 0.5 * body.speed(v) * (up - down);
    }
    if (body.figure() == nullptr && body.size() >= 6) leaveSingular(body, wish);
    wish.p_W = body.handle().p;
    wish.arrow_W = velocityOf(body, body.handleLink(), wish.p_W, wish.v);
  }

 private:
  void leaveSingular(const MovedBody& body, Wish& wish) const {
    const double now = leastSingularValue(body);
    if (now >= singular) return;
    std::vector<double> slope(body.size(), 0.0), step(body.size(), 0.0);
    double squares = 1e-6;
    for (std::size_t v = 0; v < body.size(); ++v) {
      step[v] = kProbe;
      const auto there = body.moved(step);
      step[v] = 0.0;
      if (!there) continue;
      slope[v] = (leastSingularValue(*there) - now) / kProbe;
      squares += slope[v] * slope[v];
    }
    const double strength = 1.0 - now / singular;
    for (std::size_t v = 0; v < body.size(); ++v)
      wish.v[v] += 0.3 * strength * body.speed(v) * slope[v] / std::sqrt(squares);
  }
};

}  // namespace

MadeAgent makeLimitAgent(const AgentMaking& making) {
  auto agent = std::make_unique<LimitAgent>();
  SectionReader reader(making.section);
  reader.fields().read("zone", agent->zone, kDegree, 0.1, 90.0);
  reader.fields().read("singular", agent->singular, 1.0, 0.0, 1.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
