// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/body/follow.h"
#include "agents/wishes/figure_need.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::agents {

namespace {

/// Keeps the centre of mass over the soles: the pelvis moves level, back over their middle.
class BalanceAgent final : public Agent {
 public:
  double margin = 0.05, speed = 0.2;  // m inside the soles' edge, m/s

  void wish(const AgentView& view, Wish& wish) override {
    const FigureView& figure = *view.body.figure();
    const std::array<mannequin::SegmentPlace, 2> feet{figure.pose[mannequin::Segment::kLeftFoot],
                                                      figure.pose[mannequin::Segment::kRightFoot]};
    const auto support = mannequin::supportPolygon(figure.figure, feet);
    const dvec3 p_WCom = mannequin::centerOfMass(figure.figure, figure.pose);
    const double inside = support.margin(glm::dvec2(p_WCom));
    if (inside >= margin || support.count == 0) return;
    glm::dvec2 middle(0.0);
    for (std::size_t i = 0; i < support.count; ++i) middle += support.points[i] / static_cast<double>(support.count);
    const glm::dvec2 way = middle - glm::dvec2(p_WCom);
    const double length = glm::length(way);
    if (length < 1e-6) return;
    const double pace = speed * std::clamp((margin - inside) / margin, 0.0, 1.0);
    const dvec3 velocity = pace * dvec3(way / length, 0.0);
    wish.v.assign(view.body.size(), 0.0);
    for (int k = 0; k < 3; ++k) wish.v[static_cast<std::size_t>(k)] = velocity[k];
    wish.p_W = p_WCom;
    wish.arrow_W = velocity;
  }
};

}  // namespace

MadeAgent makeBalanceAgent(const AgentMaking& making) {
  HAPTICELL_TRY(needFigure(making));
  auto agent = std::make_unique<BalanceAgent>();
  SectionReader reader(making.section);
  reader.fields().read("margin", agent->margin, 1.0, 0.001, 0.3);
  reader.fields().read("speed", agent->speed, 1.0, 0.01, 1.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
