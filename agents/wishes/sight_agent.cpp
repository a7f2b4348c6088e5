// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "agents/body/follow.h"
#include "agents/wishes/figure_need.h"
#include "mannequin/posture/vision.h"

namespace hapticell::agents {

namespace {

/// rad: a head within this of the target need not turn; the preferred zone of vision.h. Half: the head follows every
/// move; twice: the eyes go to their corners.
constexpr double kPreferred = 15.0 * kDegree;
/// 1/s, how fast the rest of a turn is made. Half: looks late; twice: the head jerks.
constexpr double kTurnRate = 2.0;
/// s between two looks for a place from which the target is seen. Half: twice the rays; twice: reacts later than a person.
constexpr double kLookEvery = 0.2;
constexpr int kDirections = 12;
/// m from the eyes, nearest first.
constexpr double kOffsets[] = {0.05, 0.10, 0.18, 0.28, 0.40};

/// Keeps the eyes on the target: turns the head, and where something is in the line of sight moves the head sideways to
/// the nearest place from which the target is seen.
class SightAgent final : public Agent {
 public:
  SightAgent(std::span<const Clearances::Obstacle> obstacles, workcell::EntityId target)
      : lines_(obstacles, target), p_WTarget_(lines_.middleOf(target)) {}
  double speed = 0.15;  // m/s of the head

  void wish(const AgentView& view, Wish& wish) override {
    if (!p_WTarget_) return;
    const FigureView& figure = *view.body.figure();
    const mannequin::Sight sight = mannequin::sightOf(figure.figure, figure.pose, *p_WTarget_);
    const int head = figure.link_of[mannequin::indexOf(mannequin::Segment::kHead)];
    const dvec3 turn = turnOf(figure, sight.p_WEyes);
    PointWish look{head, sight.p_WEyes, {dvec3(0.0), turn}, true};
    wish.v = follow(view.body, look, byRegion(view.body, {0.0, 0.0, 0.1, 0.0, 1.0}));
    if (view.t - looked_at_ >= kLookEvery) findPlace(view.t, sight.p_WEyes);
    wish.p_W = sight.p_WEyes;
    wish.arrow_W = 0.2 * glm::cross(turn, figure.pose[mannequin::Segment::kHead].R_WS[0]);
    if (!way_) return;
    const PointWish lean{head, sight.p_WEyes, {speed * *way_, dvec3(0.0)}, false};
    const auto v = follow(view.body, lean, byRegion(view.body, {0.3, 0.1, 1.0, 0.0, 0.3}));
    for (std::size_t i = 0; i < v.size(); ++i) wish.v[i] += v[i];
    wish.arrow_W = lean.velocity.linear;
  }

 private:
  /// Rotation velocity that brings the target into the preferred zone.
  dvec3 turnOf(const FigureView& figure, const dvec3& p_WEyes) const {
    const dvec3 ahead = figure.pose[mannequin::Segment::kHead].R_WS[0];
    const dvec3 to = glm::normalize(*p_WTarget_ - p_WEyes);
    const dvec3 axis = glm::cross(ahead, to);
    const double sine = glm::length(axis), angle = std::atan2(sine, glm::dot(ahead, to));
    if (angle <= kPreferred || sine < 1e-9) return dvec3(0.0);
    return std::min(1.0, kTurnRate * (angle - kPreferred)) / sine * axis;
  }

  void findPlace(double t, const dvec3& p_WEyes) {
    looked_at_ = t;
    way_.reset();
    if (lines_.isFree(p_WEyes, *p_WTarget_)) return;
    const dvec3 to = glm::normalize(*p_WTarget_ - p_WEyes);
    const dvec3 aside = std::abs(to.z) < 0.95 ? glm::normalize(glm::cross(to, dvec3(0, 0, 1))) : dvec3(1, 0, 0);
    const dvec3 above = glm::cross(aside, to);
    for (const double offset : kOffsets) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kDirections;
        const dvec3 way = std::cos(angle) * above + std::sin(angle) * aside;
        if (!lines_.isFree(p_WEyes + offset * way, *p_WTarget_)) continue;
        way_ = way;
        return;
      }
    }
  }

  LineOfSight lines_;
  std::optional<dvec3> p_WTarget_;
  std::optional<dvec3> way_;
  double looked_at_ = -1.0;
};

}  // namespace

MadeAgent makeSightAgent(const AgentMaking& making) {
  HAPTICELL_TRY(needFigure(making));
  if (making.look_at == 0)
    return makeError(making.section.fault(Text("the goal says nothing to look at"), Text("look_at = \"NAME\" in [goal]")));
  auto agent = std::make_unique<SightAgent>(making.obstacles, making.look_at);
  SectionReader reader(making.section);
  reader.fields().read("speed", agent->speed, 1.0, 0.01, 1.0);
  HAPTICELL_TRY(reader.end());
  return agent;
}

}  // namespace hapticell::agents
