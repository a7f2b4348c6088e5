// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/follow.h"
#include "agents/wishes/figure_need.h"

namespace hapticell::agents {

namespace {

/// Keeps the goal within reach of a bent arm: the shoulder comes nearer, hips first (the pelvis turns), then the spine;
/// the pelvis hardly moves, so that the balance agent may take it back.
class ReachAgent final : public Agent {
 public:
  double share = 0.8, speed = 0.2;  // Of the arm's length, m/s

  void wish(const AgentView& view, Wish& wish) override {
    const FigureView& figure = *view.body.figure();
    const auto upper_arm = mannequin::armSegment(figure.side, mannequin::Segment::kLeftUpperArm);
    const dvec3 p_WShoulder = figure.pose[upper_arm].p_WS;
    const double arm = figure.figure.upperArmLength() + figure.figure.forearmLength();
    const dvec3 way = view.goal.p_WG - p_WShoulder;
    const double length = glm::length(way), over = length - share * arm;
    if (over <= 0.0) return;
    const dvec3 velocity = (std::min(speed, 2.0 * over) / length) * way;
    const int thorax = figure.link_of[mannequin::indexOf(mannequin::Segment::kThorax)];
    wish.v = follow(view.body, {thorax, p_WShoulder, {velocity, dvec3(0.0)}, false},
                    byRegion(view.body, {0.1, 1.0, 0.6, 0.0, 0.0}));
    wish.p_W = p_WShoulder;
    wish.arrow_W = velocity;
  }
};

}  // namespace

MadeAgent makeReachAgent(const AgentMaking& making) {
  HAPTICELL_TRY(needFigure(making));
  auto agent = std::make_unique<ReachAgent>();
  SectionReader reader(making.section);
  reader.fields().read("share", agent->share, 1.0, 0.1, 1.0);
  reader.fields().read("speed", agent->speed, 1.0, 0.01, 1.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
