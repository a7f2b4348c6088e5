// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/follow.h"
#include "agents/wishes/figure_need.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/body_solver.h"

namespace hapticell::agents {

namespace {

/// Brings the posture towards comfort (the rules of the posture solver: upright over the feet, straight back, elbows
/// hanging), the more the worse its RULA score is.
class ComfortAgent final : public Agent {
 public:
  double rate = 0.5;  // Share of the way a second at the worst score.

  void wish(const AgentView& view, Wish& wish) override {
    const FigureView& figure = *view.body.figure();
    const auto scores = ergonomics::scorePosture(figure.figure, figure.posture, figure.pose, {});
    const double strain = std::clamp((scores.rula() - 1) / 6.0, 0.0, 1.0);
    mannequin::PostureTask task;
    for (const auto side : {mannequin::Side::kLeft, mannequin::Side::kRight})
      task.hands[static_cast<std::size_t>(side)] = mannequin::handPose(figure.pose, side);
    const auto resolved = mannequin::resolve(figure.figure, task, figure.pose);
    const mannequin::BodyState state = mannequin::stateOf(figure.posture);
    mannequin::VariableAxes axes;
    mannequin::findAxes(state, figure.pose, axes);
    mannequin::Variables comfortable{};
    mannequin::wishComfort(figure.figure, resolved, state, figure.pose, axes, 1.0, comfortable);
    wish.v.assign(view.body.size(), 0.0);
    const double pace = rate * strain;
    for (std::size_t v = 0; v < kFirstNeckVariable; ++v) wish.v[v] = pace * comfortable[v];
    for (std::size_t v = kFirstNeckVariable; v < wish.v.size(); ++v) {
      const std::size_t dof = 9 + v - kFirstNeckVariable;
      wish.v[v] = -pace * figure.posture.angles[dof];
    }
    wish.p_W = figure.pose[mannequin::Segment::kThorax].p_WS;
    wish.arrow_W = velocityOf(view.body, figure.link_of[mannequin::indexOf(mannequin::Segment::kThorax)], wish.p_W,
                              wish.v);
  }
};

}  // namespace

MadeAgent makeComfortAgent(const AgentMaking& making) {
  HAPTICELL_TRY(needFigure(making));
  auto agent = std::make_unique<ComfortAgent>();
  SectionReader reader(making.section);
  reader.fields().read("rate", agent->rate, 1.0, 0.01, 10.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
