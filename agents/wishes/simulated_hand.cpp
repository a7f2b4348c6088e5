// SPDX-License-Identifier: Apache-2.0
#include "agents/wishes/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hapticell::agents {

namespace {

/// s between two looks, about twice a person's time of reaction. Half: corrects faster than people do; twice: sluggish.
constexpr double kLookPeriod = 0.5;
/// m: nearer to a point on its way it goes on to the next. Half: stops at corners; twice: cuts them.
constexpr double kPassed = 0.05;
/// m before the goal where its ball need not fit: what is reached for is itself an obstacle. Half: detours to get at a
/// free goal; twice: overlooks what is right before it.
constexpr double kBeforeGoal = 0.12;
/// rad that it points off, and m/s that its hand drifts at most. Half: as exact as a machine; twice: a beginner.
constexpr double kPointsOff = 5.0 * kDegree, kDrift = 0.01;
/// m and s of drawing back. Half: often not out of the corner; twice: loses time.
constexpr double kDrawBack = 0.12, kDrawBackTime = 0.8;
constexpr int kSides = 12;
constexpr double kAside[] = {0.10, 0.18, 0.28, 0.40, 0.55};
constexpr double kAlong[] = {0.1, 0.35, 0.6, 0.85};

dvec3 unitOr(const dvec3& v, const dvec3& other) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : other;
}

}  // namespace

void SimulatedHand::choose(const AgentView& view) {
  const dvec3 from = view.body.handle().p;
  const dvec3 way = view.goal.p_WG - from;
  const double length = glm::length(way);
  over_.reset();
  if (length < kBeforeGoal) return;
  const dvec3 to = way / length;
  const dvec3 end = view.goal.p_WG - kBeforeGoal * to;
  const bool straight_failed = std::any_of(tried_.begin(), tried_.end(),
                                           [&](const dvec3& p) { return glm::length(p - view.goal.p_WG) < 1e-9; });
  if (!straight_failed && view.cell.isFreeFor(ball, from, end)) return;
  const dvec3 aside = std::abs(to.z) < 0.9 ? unitOr(glm::cross(to, dvec3(0, 0, 1)), dvec3(0, 1, 0)) : dvec3(0, 1, 0);
  const dvec3 above = glm::cross(aside, to);
  double least = std::numeric_limits<double>::infinity();
  for (const double along : kAlong) {
    for (const double offset : kAside) {
      for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        const dvec3 over = from + along * way + offset * (std::cos(angle) * above + std::sin(angle) * aside);
        const double total = judged(glm::length(over - from) + glm::length(view.goal.p_WG - over));
        const bool known = std::any_of(tried_.begin(), tried_.end(),
                                       [&](const dvec3& p) { return glm::length(p - over) < 1.5 * ball; });
        if (known || total >= least) continue;
        const dvec3 last = view.goal.p_WG - kBeforeGoal * unitOr(view.goal.p_WG - over, to);
        if (!view.cell.isFreeFor(ball, from, over) || !view.cell.isFreeFor(ball, over, last)) continue;
        least = total;
        over_ = over;
      }
    }
  }
}

Twist SimulatedHand::velocity(const AgentView& view) {
  const Pose& X_WM = view.body.handle();
  if (view.t >= back_until_ && (looked_at_ < 0.0 || view.t - looked_at_ >= kLookPeriod)) {
    looked_at_ = view.t;
    // A way that was chosen is gone to its end, unless it is closed meanwhile.
    if (!over_ || !view.cell.isFreeFor(0.5 * ball, X_WM.p, *over_)) choose(view);
    for (int k = 0; k < 3; ++k) {
      drift_[k] = random_.within(kDrift);
      off_[k] = random_.within(std::tan(kPointsOff));
    }
  }
  if (over_ && glm::length(*over_ - X_WM.p) < kPassed) over_.reset();
  const bool is_back = view.t < back_until_;
  const dvec3 ahead = over_.value_or(view.goal.p_WG);
  const dvec3 target = is_back ? back_ : ahead;
  const dvec3 way = target - X_WM.p;
  const double length = glm::length(way);
  Twist twist;
  const bool last = !is_back && !over_;
  // Near the goal it slows down and looks closely.
  const double pace = last ? std::min(speed, 2.0 * length) : speed;
  const dvec3 straight = unitOr(way, dvec3(0.0));
  const double calm = last ? std::min(1.0, length / 0.1) : 1.0;
  twist.linear = pace * unitOr(straight + calm * off_, dvec3(0.0)) + calm * drift_;
  if (view.goal.q_WG) {
    const dvec3 turn = 2.0 * difference(Pose{X_WM.p, *view.goal.q_WG}, X_WM).angular;
    const double angle = glm::length(turn);
    twist.angular = angle > turn_speed ? (turn_speed / angle) * turn : turn;
  }
  return twist;
}

void SimulatedHand::drawBack(const AgentView& view) {
  tried_.push_back(over_.value_or(view.goal.p_WG));
  const dvec3 from = view.body.handle().p;
  dvec3 away = unitOr(from - tried_.back(), dvec3(0, 0, 1));
  for (int k = 0; k < 3; ++k) away[k] += random_.within(0.6);
  back_ = from + kDrawBack * unitOr(away, dvec3(0, 0, 1));
  back_until_ = view.t + kDrawBackTime;
  over_.reset();
  looked_at_ = -1.0;
}

void SimulatedHand::beLed() {
  over_.reset();
  tried_.clear();
  back_until_ = looked_at_ = -1.0;
}

}  // namespace hapticell::agents
