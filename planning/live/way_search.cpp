// SPDX-License-Identifier: Apache-2.0
#include "planning/live/way_search.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "planning/standing_figure.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {

namespace {

/// m a radian, as trajectory::PathProgress. Half: turning is cheap; twice: ways that turn little are preferred.
constexpr double kMetresPerRadian = 0.1;
/// m of way between two poses of a robot's way: its tool goes in arcs. Half: twice the poses; twice: 0.1 mm off an arc
/// of 0.5 m.
constexpr double kArcStep = 0.02;
/// m: a held entity at rest against something is farther away than this (FreeMotion::kStandOff). Half: still; twice:
/// its start counts as blocked.
constexpr double kTouching = 2e-6;
/// Places tried around a start that is too near to something, and the farthest, m. Half: a corner is left half as
/// often; twice: twice the time where there is no room at all.
constexpr int kTries = 200;
constexpr double kFarthest = 0.02;
/// Of the push (out of the tube, m), how far ahead the hand's way is taken to lead: as far as it has gone astray, at
/// most three times. Half: the plan turns back at once; twice: often not free.
constexpr double kAhead[] = {3.0, 2.0, 1.0, 0.5};
/// Configurations of the hand's way that are given to a search, evenly. Half: bridges in coarse steps; twice: more
/// checks before each search.
constexpr std::size_t kMostHints = 64;
/// Of the checks of a search: for a way that passes where the hand pushes, as any other way will do too. Half: a
/// place from which nothing leads on costs twice as much; twice: narrow ways through it are missed.
constexpr std::size_t kPassedShare = 4;
/// s of a search in virtual time: its checks alone end it, so that the load of the machine decides nothing.
constexpr double kNoLimit = 1e6;

Pose toolOf(FreeSpace& space, const EntityConfiguration& at) {
  return space.toolAt(at);
}

double wayBetween(const Pose& a, const Pose& b) {
  const trajectory::PoseDistance off = trajectory::distanceBetween(a, b);
  return off.position + kMetresPerRadian * off.angle;
}

bool isSamePlace(const EntityConfiguration& a, const EntityConfiguration& b) {
  return a.joints == b.joints && a.X_WE.p == b.X_WE.p && a.X_WE.q == b.X_WE.q;
}

/// At most so many of them, evenly, the last one among them.
std::vector<EntityConfiguration> thinned(const std::vector<EntityConfiguration>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<EntityConfiguration> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
  return some;
}

}  // namespace

Expected<void> WaySearch::prepare(const manipulation::PlanView& view) {
  // A mannequin's feet stay where they are now, and so does all that its hand does not move.
  const bool goes_on = !view.hand && !hand_;
  if (view.scene == scene_ && view.entity == entity_ && space_ && goes_on) return {};
  scene_ = view.scene;
  entity_ = view.entity;
  hand_ = view.hand;
  space_.reset();
  manipulation::Placements placements = view.placements;
  if (hand_) placements[entity_] = view.standing;
  auto made = FreeSpace::create(view.scene, view.entity, configuration_, placements, hand_);
  HAPTICELL_TRY(made);
  space_.emplace(std::move(*made));
  return {};
}

/// The start itself, or a place near it that keeps the clearance and can be reached from it.
std::optional<EntityConfiguration> WaySearch::freeStart(const EntityConfiguration& at) {
  space_->setClearance(options_.clearance);
  if (space_->isFree(at)) return at;
  std::mt19937_64 random(options_.seed + searches_);
  std::normal_distribution<double> normal;
  for (int i = 0; i < kTries; ++i) {
    const double reach = kFarthest * std::max(0.05, static_cast<double>(i) / kTries);
    EntityConfiguration near = at;
    if (const StandingFigure* figure = space_->figure()) {
      StandingFigure::Numbers numbers = figure->numbersOf(at);
      for (double& number : numbers) number += reach * normal(random);
      near = figure->configurationOf(numbers);
    } else if (space_->hasJoints()) {
      for (double& joint : near.joints) joint += reach * normal(random);
    } else {
      const dvec3 way(normal(random), normal(random), normal(random)), turn(normal(random), normal(random), normal(random));
      near.X_WE = displaced(at.X_WE, {reach * way, 3.0 * reach * turn});
    }
    space_->setClearance(options_.clearance);
    if (!space_->isFree(near)) continue;
    space_->setClearance(kTouching);
    if (space_->isFree(at, near)) return near;
  }
  return std::nullopt;
}

/// From where it stands to a place from which a plan can begin: itself, one near by, or one where the hand has led it
/// past; empty: there is none.
std::vector<EntityConfiguration> WaySearch::startOf(const manipulation::PlanView& view) {
  std::vector<EntityConfiguration> way{view.standing};
  if (const auto near = freeStart(view.standing)) {
    if (!isSamePlace(*near, view.standing)) way.push_back(*near);
    return way;
  }
  for (std::size_t i = view.trail->size(); i-- > 0;) {
    space_->setClearance(kTouching);
    if (!space_->isFree(way.back(), (*view.trail)[i])) break;
    way.push_back((*view.trail)[i]);
    space_->setClearance(options_.clearance);
    if (space_->isFree(way.back())) return way;
  }
  return {};
}

/// A place on the hand's own way, on from where it pushes.
std::optional<Pose> WaySearch::passedByHand(const manipulation::PlanView& view, const EntityConfiguration& start) {
  if (view.push_W == dvec3(0.0)) return std::nullopt;
  space_->setClearance(options_.clearance);
  for (const double share : kAhead) {
    Pose X_WT = toolOf(*space_, start);
    X_WT.p += share * view.push_W;
    if (space_->hasJoints()) return X_WT;  // Whether joints bring the tool there is for the plan to find out.
    EntityConfiguration there = start;
    there.X_WE = X_WT;
    if (space_->isFree(there) && space_->isFree(start, there)) return X_WT;
  }
  return std::nullopt;
}

std::vector<EntityConfiguration> WaySearch::hintsFor(const manipulation::PlanView& view) const {
  std::vector<EntityConfiguration> hints = thinned(*view.trail, kMostHints);
  if (space_->hasJoints()) return hints;
  for (const Pose& X_WT : options_.hints) hints.push_back({X_WT, {}});
  return hints;
}

/// Poses of the moved frame; a robot's tool goes in arcs between waypoints.
void WaySearch::sample(Found& found) const {
  const std::vector<EntityConfiguration>& waypoints = found.waypoints;
  found.length = 0.0;
  found.X_WM.clear();
  found.postures.clear();
  const auto add = [&](const EntityConfiguration& at) {
    const Pose X_WM = space_->toolAt(at) * found.X_TM;
    const double way = found.X_WM.empty() ? 0.0 : wayBetween(found.X_WM.back(), X_WM);
    if (!found.X_WM.empty() && way < 1e-6) {
      // The arm moves behind a tool at rest: it is to get there before the tool goes on.
      if (space_->hasJoints()) found.postures.back() = at;
      return;
    }
    found.length += way;
    found.X_WM.push_back(X_WM);
    if (space_->hasJoints()) found.postures.push_back(at);
  };
  add(waypoints.front());
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    // A solid's own frame goes straight, another one does not.
    const bool arcs = space_->hasJoints() || wayBetween({}, found.X_TM) > 1e-6;
    const double bound = arcs ? space_->pathBound(waypoints[i - 1], waypoints[i]) : 0.0;
    const int pieces = std::clamp(static_cast<int>(std::ceil(bound / kArcStep)), 1, 200);
    for (int k = 1; k <= pieces; ++k) {
      add(space_->between(waypoints[i - 1], waypoints[i], static_cast<double>(k) / pieces));
    }
  }
  if (found.X_WM.size() >= 2) return;
  found.X_WM.clear();
  found.postures.clear();
}

void WaySearch::join(Found& found, const manipulation::PlanView& now) {
  /// Waypoints of the way that are tried, the farthest first. Half: more of it is gone twice; twice: twice the checks.
  constexpr std::size_t kTried = 8;
  const auto& way = found.waypoints;
  if (found.X_WM.empty() || !space_ || isSamePlace(way.front(), now.standing)) return;
  const auto onFrom = [&](std::size_t k) {
    std::vector<EntityConfiguration> joined{now.standing};
    joined.insert(joined.end(), way.begin() + static_cast<std::ptrdiff_t>(k), way.end());
    return joined;
  };
  for (const double clearance : {options_.clearance, 0.5 * options_.clearance, kTouching}) {
    space_->setClearance(clearance);
    for (std::size_t k = std::min(way.size() - 1, kTried) + 1; k-- > 0;) {
      if (!space_->isFree(now.standing, way[k])) continue;
      found.waypoints = onFrom(k);
      return sample(found);
    }
  }
  const double spacing = 2.0 * wayBetween(toolOf(*space_, way.front()), toolOf(*space_, now.standing));
  std::vector<EntityConfiguration> back{now.standing};
  for (std::size_t i = now.trail->size(); i-- > 0;) {
    const EntityConfiguration& at = (*now.trail)[i];
    back.push_back(at);
    if (wayBetween(toolOf(*space_, at), toolOf(*space_, way.front())) < spacing && space_->isFree(at, way.front())) break;
  }
  back.insert(back.end(), way.begin(), way.end());
  found.waypoints = std::move(back);
  sample(found);
}

WaySearch::Found WaySearch::find(const manipulation::PlanView& view, const std::atomic<bool>* stop) {
  Found found;
  found.answers = view.insistences;
  found.hold = view.hold;
  const auto fail = [&found](Failure::Kind kind, Text reason) {
    Failure& failure = found.result.failure.emplace();
    failure.kind = kind;
    failure.reason = std::move(reason);
    return found;
  };
  const workcell::Entity* entity = view.scene ? view.scene->find(view.entity) : nullptr;
  if (entity != nullptr && entity->figure() != nullptr && !view.hand)
    return fail(Failure::Kind::kStart,
                Text("a mannequin can be planned for only while its left or right hand moves it, with nothing locked and no steps allowed"));
  if (const auto prepared = prepare(view); !prepared) return fail(Failure::Kind::kStart, prepared.error().text());
  ++searches_;
  const Pose X_TM = space_->toolAt(view.standing).inverse() * view.X_WM;
  // What a robot's hand moves must be its tool: else the joints that are planned would not be those that follow.
  if (space_->hasJoints() && wayBetween({}, X_TM) > 1e-6)
    return fail(Failure::Kind::kStart,
                Text("a robot can be planned for only while it is moved by its tool (TCP)"));
  found.X_TM = X_TM;
  std::vector<EntityConfiguration> waypoints = startOf(view);
  if (waypoints.empty()) return fail(Failure::Kind::kStart, Text("there is no room around the place where it is"));
  Problem problem;
  problem.scene = view.scene;
  problem.entity = view.entity;
  problem.hand = view.hand;
  problem.placements = view.placements;
  problem.start = waypoints.back();
  problem.goal = options_.goal;
  problem.clearance = options_.clearance;
  problem.seed = options_.seed + searches_;
  problem.most_checks = options_.most_checks;
  problem.time_limit_s = options_.in_virtual_time ? kNoLimit : options_.most_seconds;
  problem.stop = stop;
  if (const auto passed = passedByHand(view, waypoints.back())) {
    problem.through = {*passed};
    problem.most_checks = std::max<std::size_t>(1, options_.most_checks / kPassedShare);
  }
  auto planned = plan(problem, *space_);
  const auto fails = [&] {
    return planned && !planned->plan && planned->failure->kind != Failure::Kind::kCancelled;
  };
  const auto tryAgain = [&] {
    const std::size_t before = planned->checks;
    planned = plan(problem, *space_);
    if (planned) planned->checks += before;
  };
  if (!problem.through.empty() && fails()) {
    // Nothing leads on from there: any way is better than none.
    problem.through.clear();
    problem.most_checks = options_.most_checks;
    tryAgain();
  }
  if (fails()) {
    // What the hand has shown is a bridge where the search by itself finds none; else it would lead back first.
    problem.hints = hintsFor(view);
    problem.seed = ~problem.seed;  // The same search once more would fail as before.
    tryAgain();
  }
  if (!planned) return fail(Failure::Kind::kStart, planned.error().text());
  found.result = std::move(*planned);
  if (!found.result.plan) return found;
  const std::vector<EntityConfiguration>& planned_way = found.result.plan->waypoints;
  waypoints.insert(waypoints.end(), planned_way.begin() + 1, planned_way.end());
  found.waypoints = std::move(waypoints);
  sample(found);
  return found;
}

}  // namespace hapticell::planning
