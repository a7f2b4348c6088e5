// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_loop.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hapticell::agents {

namespace {

/// m: nearer pairs bend the motion. Half: braked late; twice: brakes where nothing is in the way.
constexpr double kBendWithin = 0.03;
/// s in which a pair may lose its distance to the clearance. Half: harder stops; twice: creeps towards surfaces.
constexpr double kBrakeTime = 0.15;
/// Of the clearance, what the bending aims at, so that steps do not end on the clearance itself and stop there. Half of
/// the surplus: slides along surfaces in smaller steps; twice: narrow places are given up earlier.
constexpr double kSoftShare = 1.5;
/// Sweeps over the pairs that bend. Half: corners of three surfaces are entered a little and cost cut steps; twice: no
/// change seen.
constexpr int kSweeps = 8;
/// Halvings of a step that would come too near. Half: stops earlier in narrow places; twice: steps too small to matter.
constexpr int kTries = 6;
/// m that a radian counts like, for the remaining way. Half, twice: turns count less or more in what is progress.
constexpr double kRemainingLever = 0.25;
/// m between parts of the entity itself: arms hang beside a trunk. Half, twice: flesh is given up to no more.
constexpr double kOwnClearance = 1e-3;
/// m, of what is lost to rounding.
constexpr double kRounding = 1e-9;
/// rad or m of what moves most in a step back: less than a step at full speed. Half: draws back at half the speed; twice:
/// faster than the figure moves.
constexpr double kBackStep = 0.01;
/// Steps that are kept, of a minute. Half: cannot draw back as far; twice: memory.
constexpr std::size_t kMostKept = 3000;

/// The most that the base (m, rad) or a joint moves between two configurations.
double apart(const manipulation::EntityConfiguration& a, const manipulation::EntityConfiguration& b) {
  const Twist way = difference(a.X_WE, b.X_WE);
  double most = std::max(glm::length(way.linear), glm::length(way.angular));
  for (std::size_t i = 0; i < a.joints.size(); ++i) most = std::max(most, std::abs(a.joints[i] - b.joints[i]));
  return most;
}

}  // namespace

AgentLoop::AgentLoop(std::unique_ptr<MovedBody> body, Clearances clearances, std::vector<WeightedAgent> agents,
                     AgentGoal goal, double clearance, workcell::EntityId looked_at)
    : body_(std::move(body)),
      clearances_(std::move(clearances)),
      lines_(clearances_.obstacles(), looked_at),
      agents_(std::move(agents)),
      goal_(std::move(goal)),
      clearance_(clearance) {
  clearances_.look(body_->configuration(), kLook);
}

bool AgentLoop::step() {
  if (back_) return stepBack();
  std::vector<double> v = sumOfWishes();
  cutToSpeeds(v);
  bendAlong(v);
  cutToSpeeds(v);
  t_ += kStep;
  const bool moved = makeStep(std::move(v));
  way_.update(*body_);
  return moved;
}

void AgentLoop::drawBack(double far) {
  back_ = Back{body_->handle().p, far};
  way_ = FollowedWay();
}

bool AgentLoop::stepBack() {
  t_ += kStep;
  for (ShownWish& wish : wishes_) {
    wish.arrow_W = dvec3(0.0);
    wish.strength = 0.0;
  }
  double gone = 0.0;
  while (gone < kBackStep && !came_.empty() && glm::length(body_->handle().p - back_->p_WM) < back_->far) {
    std::unique_ptr<MovedBody> there = std::move(came_.back());
    came_.pop_back();
    // The proof of the step that led here, from where it was made.
    clearances_.look(there->configuration(), kLook);
    if (clearances_.safeShare(body_->configuration()) < 1.0) {
      clearances_.look(body_->configuration(), kLook);
      break;
    }
    gone += apart(there->configuration(), body_->configuration());
    body_ = std::move(there);
  }
  if (gone > 0.0) return true;
  back_.reset();
  return false;
}

std::vector<double> AgentLoop::sumOfWishes() {
  std::vector<double> sum(body_->size(), 0.0);
  const AgentView now = view();
  wishes_.clear();
  for (WeightedAgent& one : agents_) {
    ShownWish shown{one.name, one.weight, one.enabled, body_->handle().p, dvec3(0.0), 0.0};
    Wish wish;
    if (one.enabled && one.weight > 0.0) one.agent->wish(now, wish);
    for (std::size_t v = 0; v < wish.v.size(); ++v) {
      const double most = body_->speed(v);
      if (most <= 0.0) continue;
      sum[v] += one.weight * wish.v[v];
      shown.strength = std::max(shown.strength, one.weight * std::abs(wish.v[v]) / most);
    }
    if (!wish.v.empty()) {
      shown.p_W = wish.p_W;
      shown.arrow_W = one.weight * wish.arrow_W;
    }
    wishes_.push_back(std::move(shown));
  }
  return sum;
}

void AgentLoop::bendAlong(std::vector<double>& v) const {
  const auto screws = body_->screws();
  struct Row {
    std::vector<double> g;  ///< How the distance grows with each variable.
    double least = 0.0, squares = 0.0;
  };
  std::vector<Row> rows;
  for (const NearPair& pair : clearances_.near()) {
    if (pair.distance >= kBendWithin) break;
    Row row{std::vector<double>(v.size(), 0.0), -(pair.distance - kSoftShare * clearanceOf(pair)) / kBrakeTime, 0.0};
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double speed = body_->speed(i);
      if (speed <= 0.0) continue;
      const bool other = pair.other_link >= 0 && body_->carries(i, pair.other_link);
      if (body_->carries(i, pair.link)) row.g[i] += glm::dot(pair.nhat_W, screws[i].at(pair.p_WA));
      if (other) row.g[i] -= glm::dot(pair.nhat_W, screws[i].at(pair.p_WB));
      row.squares += row.g[i] * row.g[i] * speed;
    }
    if (row.squares > 1e-8) rows.push_back(std::move(row));
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const Row& row : rows) {
      double rate = 0.0;
      for (std::size_t i = 0; i < v.size(); ++i) rate += row.g[i] * v[i];
      if (rate >= row.least) continue;
      const double push = (row.least - rate) / row.squares;
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += push * row.g[i] * body_->speed(i);
    }
  }
}

void AgentLoop::cutToSpeeds(std::vector<double>& v) const {
  double over = 1.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double most = body_->speed(i);
    if (most <= 0.0) v[i] = 0.0;
    if (most > 0.0) over = std::max(over, std::abs(v[i]) / most);
  }
  for (double& one : v) one /= over;
}

bool AgentLoop::makeStep(std::vector<double> v) {
  for (double& one : v) one *= kStep;
  std::map<std::size_t, double> before;
  for (const NearPair& pair : clearances_.near()) before[pair.index] = pair.distance;
  const manipulation::EntityConfiguration from = body_->configuration();
  bool looked_elsewhere = false;
  for (int i = 0; i < kTries; ++i) {
    if (looked_elsewhere) clearances_.look(from, kLook);
    looked_elsewhere = false;
    auto there = body_->moved(v);
    double share = there ? clearances_.safeShare(there->configuration()) : 0.5;
    if (share < 1.0) {
      for (double& one : v) one *= 0.95 * share;
      there = body_->moved(v);
      share = there ? clearances_.safeShare(there->configuration()) : 0.0;
    }
    if (share >= 1.0) {
      looked_elsewhere = true;
      const auto& near = clearances_.look(there->configuration(), kLook);
      const bool keeps = std::all_of(near.begin(), near.end(), [&](const NearPair& pair) {
        const auto had = before.find(pair.index);
        const double kept = clearanceOf(pair);
        const double least = had == before.end() ? kept : std::min(kept, had->second);
        return pair.distance >= least - kRounding;
      });
      if (keeps) {
        came_.push_back(std::exchange(body_, std::move(there)));
        if (came_.size() > kMostKept) came_.pop_front();
        return true;
      }
    }
    for (double& one : v) one *= 0.5;
    // Legs follow the pelvis, which the bending does not foresee.
    if (i == kTries / 2 && body_->figure() != nullptr) std::fill_n(v.begin(), 6, 0.0);
  }
  clearances_.look(from, kLook);
  return false;
}

double AgentLoop::clearanceOf(const NearPair& pair) const {
  return pair.other_link < 0 ? clearance_ : std::min(clearance_, kOwnClearance);
}

double AgentLoop::nearestObstacle() const {
  for (const NearPair& pair : clearances_.near()) {
    if (pair.other_link < 0) return pair.distance;
  }
  return kLook;
}

double AgentLoop::remaining() const {
  const Pose& X_WM = body_->handle();
  double way = glm::length(goal_.p_WG - X_WM.p);
  if (goal_.q_WG) way += kRemainingLever * glm::length(difference(Pose{X_WM.p, *goal_.q_WG}, X_WM).angular);
  return way;
}

bool AgentLoop::hasArrived() const {
  const Pose& X_WM = body_->handle();
  if (glm::length(goal_.p_WG - X_WM.p) > goal_.tolerance) return false;
  return !goal_.q_WG ||
         glm::length(difference(Pose{X_WM.p, *goal_.q_WG}, X_WM).angular) <= goal_.angle_tolerance;
}

std::string AgentLoop::handOverDeadlock() {
  const AgentView now = view();
  for (WeightedAgent& one : agents_) {
    if (one.enabled && one.weight > 0.0 && one.agent->onDeadlock(now)) return one.name;
  }
  return {};
}

}  // namespace hapticell::agents
