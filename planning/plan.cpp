// SPDX-License-Identifier: Apache-2.0
#include "planning/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "planning/goal_states.h"
#include "planning/leaving.h"
#include "planning/search.h"
#include "planning/shortening.h"

namespace hapticell::planning {

namespace {

using Clock = std::chrono::steady_clock;
using Path = std::vector<EntityConfiguration>;

/// More than the clearance that is planned with, so that corners can be rounded off: a share of it, and m. Half: slower
/// at corners; twice: passages have to be wider.
constexpr double kSlackShare = 0.1, kLeastSlack = 2e-4;
/// Of the checks that a search may make: for joining a hint. Half: hints are given up sooner; twice: a bad hint costs
/// more.
constexpr std::size_t kHintShare = 20;
/// Clearances up to which distances at the waypoints are measured. Half: all of them are the clearance; twice: some ms
/// more in a full cell.
constexpr double kMeasured = 2.0;
/// Pieces of a motion by which its length is measured. Half: 1 % short for a quarter turn; twice: twice the time.
constexpr int kLengthPieces = 16;

bool isValid(const EntityConfiguration& at, const FreeSpace& space) {
  return at.X_WE.isValid() && at.joints.size() == space.present().joints.size() &&
         std::all_of(at.joints.begin(), at.joints.end(), [](double q) { return std::isfinite(q); });
}

Expected<void> checkNumbers(const Problem& problem, const FreeSpace& space) {
  const Text place("the plan for '%1'", space.entity().name);
  if (!(problem.clearance >= 0.0) || !(problem.clearance <= 10.0))
    return makeError({.place = place, .found = "a clearance that is not valid", .expected = "0 to 10 metres"});
  if (problem.start && !isValid(*problem.start, space))
    return makeError(
        {.place = place, .found = "a start that is not valid", .expected = "finite numbers for all joints"});
  for (const EntityConfiguration& hint : problem.hints) {
    if (!isValid(hint, space))
      return makeError(
          {.place = place, .found = "a hint that is not valid", .expected = "finite numbers for all joints"});
  }
  return {};
}

/// One problem on its way to a plan.
class Planning {
 public:
  Planning(const Problem& problem, const FreeSpace& space, double slack)
      : problem_(problem), space_(space.fresh()), slack_(slack) {
    space_.setStop(problem.stop);
    space_.setClearance(problem.clearance + slack);
    start_ = problem.start.value_or(space_.present());
    const double limit = std::clamp(problem.time_limit_s, 0.0, 1e6);
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit));
    threads_ =
        problem.threads > 0 ? problem.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }

  Expected<PlanResult> run() {
    PlanResult result;
    result.note = space_.note();
    path_ = {start_};
    if (!space_.isFree(start_)) {
      const auto out = problem_.leaves_contact && !isStopped() ? wayOut(space_, start_) : std::nullopt;
      if (!out) {
        result.failure = isStopped() ? cancelled() : notLeft();
        return result;
      }
      path_.push_back(*out);
    }
    const auto made = makePath(result);
    HAPTICELL_TRY(made);
    result.checks += space_.checks();
    if (isStopped()) result.failure = cancelled();
    if (result.failure) return result;
    result.plan = finished();
    return result;
  }

 private:
  bool isStopped() const { return problem_.stop != nullptr && problem_.stop->load(std::memory_order_relaxed); }

  Failure notLeft() {
    Failure failure = startFailure(space_, start_);
    if (problem_.leaves_contact) failure.reason = whyNoWayOut(space_, start_, failure.reason);
    return failure;
  }

  static Failure cancelled() {
    Failure failure;
    failure.kind = Failure::Kind::kCancelled;
    failure.reason = Text("planning was cancelled");
    return failure;
  }

  /// The way from pose to pose, each part shortened; a failure goes to the result.
  Expected<void> makePath(PlanResult& result) {
    for (std::size_t i = 0; i <= problem_.through.size() && !result.failure; ++i) {
      const bool is_last = i == problem_.through.size();
      const Goal target = is_last ? problem_.goal : Goal(goal::ToPose{problem_.through[i]});
      auto states = goalStates(target, space_, path_.back(), problem_.seed + i);
      HAPTICELL_TRY(states);
      const bool may_reach = is_last && problem_.leaves_contact && states->failure && !isStopped();
      const std::vector<Reached> reached = may_reach ? reachable(states->tight) : std::vector<Reached>();
      for (const Reached& one : reached) states->free.push_back(one.from);
      if (reached.empty() && states->failure) {
        result.failure = isStopped() ? cancelled() : std::move(states->failure);
        return {};
      }
      addPart(states->free, i, result);
      for (const Reached& one : reached) {
        if (result.failure || !isSame(path_.back(), one.from)) continue;
        path_.push_back(one.goal);
        break;
      }
      if (!is_last) through_.push_back(path_.size() - 1);
    }
    return {};
  }

  /// A goal that is in contact or too near, and where the motion that reaches it begins.
  struct Reached {
    EntityConfiguration from, goal;
  };

  std::vector<Reached> reachable(const Path& tight) {
    std::vector<Reached> reached;
    for (const EntityConfiguration& goal : tight) {
      if (auto from = wayOut(space_, goal)) reached.push_back({std::move(*from), goal});
    }
    return reached;
  }

  static bool isSame(const EntityConfiguration& a, const EntityConfiguration& b) {
    return a.joints == b.joints && a.X_WE.p == b.X_WE.p && a.X_WE.q == b.X_WE.q;
  }

  void addPart(const Path& goals, std::size_t part, PlanResult& result) {
    Path way = problem_.through.empty() && !problem_.hints.empty() ? byHints(goals, result) : Path();
    if (way.empty()) {
      SearchResult found = search(space_, jobFrom(path_.back(), goals, part, problem_.most_checks));
      result.checks += found.checks;
      result.planner = found.planner;
      if (found.path.empty()) {
        result.failure = isStopped() ? cancelled() : noWay(found, goals);
        return;
      }
      way = std::move(found.path);
    }
    way = shortened(space_, std::move(way), problem_.seed + part);
    path_.insert(path_.end(), way.begin() + 1, way.end());
  }

  SearchJob jobFrom(const EntityConfiguration& start, const Path& goals, std::size_t part, std::size_t checks) const {
    SearchJob job;
    job.start = start;
    job.goals = goals;
    job.seed = problem_.seed + 1000 * part;
    job.most_checks = checks;
    job.threads = threads_;
    job.deadline = deadline_;
    job.stop = problem_.stop;
    if (problem_.progress) {
      job.progress = [this, part](double share) {
        problem_.progress((static_cast<double>(part) + share) / static_cast<double>(problem_.through.size() + 1));
      };
    }
    return job;
  }

  /// Stretches of the hints that are free, as they follow each other.
  std::vector<Path> bridges() {
    std::vector<Path> runs;
    bool goes_on = false;
    for (const EntityConfiguration& hint : problem_.hints) {
      EntityConfiguration at = hint;
      if (!space_.hasJoints()) at.joints = start_.joints;
      if (!space_.isFree(at)) {
        goes_on = false;
        continue;
      }
      if (goes_on && space_.isFree(runs.back().back(), at)) {
        runs.back().push_back(std::move(at));
      } else {
        runs.push_back({std::move(at)});
      }
      goes_on = true;
    }
    return runs;
  }

  /// From bridge to bridge to a goal; empty where one of the ways between them is not found.
  Path byHints(const Path& goals, PlanResult& result) {
    Path way{path_.back()};
    const std::size_t checks = std::max<std::size_t>(1, problem_.most_checks / kHintShare);
    const auto join = [&](const Path& to) {
      SearchResult found = search(space_, jobFrom(way.back(), to, 0, checks));
      result.checks += found.checks;
      if (found.path.empty()) return false;
      way.insert(way.end(), found.path.begin() + 1, found.path.end());
      return true;
    };
    const std::size_t before = result.checks;
    for (const Path& bridge : bridges()) {
      // Bridges that are all out of reach are not to cost more than a search without them.
      if (result.checks - before > problem_.most_checks) return {};
      if (!join({bridge.front()})) continue;
      way.insert(way.end(), bridge.begin() + 1, bridge.end());
    }
    if (way.size() == 1 || !join(goals)) return {};
    result.planner = "hints";
    return way;
  }

  Failure noWay(const SearchResult& found, const Path& goals) {
    Failure failure;
    const auto most = std::max_element(found.blocks.begin(), found.blocks.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != found.blocks.end()) failure.blocked_by = most->first;
    const bool in_time = Clock::now() < deadline_;
    const Text how = in_time ? Text("no way to the goal was found with %1 checks", found.checks)
                             : Text("no way to the goal was found in %1 s", shortSeconds(problem_.time_limit_s));
    failure.reason =
        failure.blocked_by.empty() ? how : Text("%1; most often %2 was in the way", how, failure.blocked_by);
    if (found.nearest) {
      failure.nearest = found.nearest;
      failure.X_WT_nearest = space_.toolAt(*found.nearest);
      failure.nearest_distance = glm::length(failure.X_WT_nearest->p - space_.toolAt(goals.front()).p);
      for (const EntityConfiguration& goal : goals) {
        failure.nearest_distance =
            std::min(failure.nearest_distance, glm::length(failure.X_WT_nearest->p - space_.toolAt(goal).p));
      }
    }
    return failure;
  }

  static std::string shortSeconds(double seconds) {
    std::string text = std::to_string(seconds);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
  }

  Plan finished() {
    Plan plan;
    plan.slack = slack_;
    plan.leaves_contact = problem_.leaves_contact;
    plan.clearance_min = kMeasured * space_.clearance();
    dvec3 p_WT = space_.toolAt(path_.front()).p;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      plan.clearance_min = std::min(plan.clearance_min, space_.clearanceAt(path_[i], plan.clearance_min));
      for (int k = 1; i > 0 && k <= kLengthPieces; ++k) {
        const auto at = space_.between(path_[i - 1], path_[i], static_cast<double>(k) / kLengthPieces);
        const dvec3 next = space_.toolAt(at).p;
        plan.length += glm::length(next - p_WT);
        p_WT = next;
      }
    }
    plan.waypoints = std::move(path_);
    plan.through = std::move(through_);
    plan.X_WThrough = problem_.through;
    plan.hand = problem_.hand;
    if (const auto* to = std::get_if<goal::ToPose>(&problem_.goal)) plan.X_WGoal = to->X_WT;
    return plan;
  }

  const Problem& problem_;
  FreeSpace space_;
  const double slack_;
  EntityConfiguration start_;
  Clock::time_point deadline_;
  int threads_ = 1;
  Path path_;
  std::vector<std::size_t> through_;
};

}  // namespace

const char* toString(Failure::Kind kind) {
  constexpr const char* kWords[] = {"start", "reach", "limit", "blocked", "no_way", "cancelled"};
  return kWords[static_cast<std::size_t>(kind)];
}

Expected<PlanResult> plan(const Problem& problem, const FreeSpace& space) {
  HAPTICELL_TRY(checkNumbers(problem, space));
  const auto begin = Clock::now();
  const double slack = std::max(kLeastSlack, kSlackShare * problem.clearance);
  auto result = Planning(problem, space, slack).run();
  HAPTICELL_TRY(result);
  // Start or goal may have the clearance, but no more.
  const bool is_tight = result->failure && (result->failure->kind == Failure::Kind::kStart ||
                                            result->failure->kind == Failure::Kind::kBlocked);
  if (is_tight) {
    const std::size_t checks = result->checks;
    result = Planning(problem, space, 0.0).run();
    HAPTICELL_TRY(result);
    result->checks += checks;
  }
  result->seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

Expected<PlanResult> plan(const Problem& problem, const config::Configuration& configuration) {
  const auto space = FreeSpace::create(problem.scene, problem.entity, configuration, problem.placements, problem.hand,
                                       problem.with_axes);
  HAPTICELL_TRY(space);
  return plan(problem, *space);
}

}  // namespace hapticell::planning
