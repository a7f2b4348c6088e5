// SPDX-License-Identifier: Apache-2.0
#include "planning/search.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <random>

#include "geometry/system/assertion.h"
#include "geometry/system/in_parallel.h"
#include "planning/coordinates.h"

namespace hapticell::planning {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Checks of each search in the first round; each further round has twice as many. Half: more changes between searches;
/// twice: an unlucky first search costs more.
constexpr std::size_t kFirstRound = 256;
/// Rounds in which another search joins, from the second on: an easy problem then costs one search alone. Half, twice:
/// as kFirstRound.
constexpr std::size_t kSearchesARound = 2;

/// Samples that follow from a seed; OMPL's own draw from one generator for the whole process.
class SeededSampler final : public ob::StateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, const Coordinates& coordinates, std::uint64_t seed)
      : ob::StateSampler(space), coordinates_(coordinates), random_(seed) {}
  void sampleUniform(ob::State* state) override { coordinates_.sample(random_, state); }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    coordinates_.sample(random_, state);
    const double apart = space_->distance(near, state);
    const double way = distance * static_cast<double>(random_() >> 11) * 0x1.0p-53;
    if (apart > way) space_->interpolate(near, state, way / apart, state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

 private:
  const Coordinates& coordinates_;
  std::mt19937_64 random_;
};

/// Asks the space and notes what is in the way.
class SpaceCheck {
 public:
  SpaceCheck(FreeSpace space, const Coordinates& coordinates) : space_(std::move(space)), coordinates_(coordinates) {}
  bool isFree(const ob::State* at) { return noted(space_.isFree(coordinates_.read(at))); }
  bool isFree(const ob::State* from, const ob::State* to) {
    return noted(space_.isFree(coordinates_.read(from), coordinates_.read(to)));
  }
  std::size_t checks() const { return space_.checks(); }
  const std::map<std::string, std::size_t>& blocks() const { return blocks_; }

 private:
  bool noted(bool is_free) {
    if (!is_free) {
      if (const auto blocker = space_.blocker()) ++blocks_[blocker->met];
    }
    return is_free;
  }

  FreeSpace space_;
  const Coordinates& coordinates_;
  std::map<std::string, std::size_t> blocks_;
};

class ExactMotions final : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& information, SpaceCheck& check)
      : ob::MotionValidator(information), check_(check) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override { return check_.isFree(from, to); }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (check_.isFree(from, to)) return true;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
    last_valid.second = 0.0;
    return false;
  }

 private:
  SpaceCheck& check_;
};

/// A planner of OMPL whose own random numbers follow from a seed.
template <typename Planner>
struct Seeded final : Planner {
  Seeded(const ob::SpaceInformationPtr& information, std::uint64_t seed) : Planner(information) {
    this->rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }
};

template <typename Planner>
ob::PlannerPtr makePlanner(const ob::SpaceInformationPtr& information, std::uint64_t seed, double range) {
  auto planner = std::make_shared<Seeded<Planner>>(information, seed);
  planner->setRange(range);
  return planner;
}

/// One search: a planner of OMPL with its space, and how far it is.
class OneSearch {
 public:
  OneSearch(const FreeSpace& space, const Coordinates& coordinates, const SearchJob& job, const SearchKind& kind,
            std::uint64_t seed)
      : coordinates_(coordinates), check_(space.fresh(), coordinates), kind_(kind) {
    space_ = coordinates.makeSpace();
    space_->setStateSamplerAllocator(
        [this, seed](const ob::StateSpace* of) { return std::make_shared<SeededSampler>(of, coordinates_, seed); });
    information_ = std::make_shared<ob::SpaceInformation>(space_);
    information_->setStateValidityChecker([this](const ob::State* state) { return check_.isFree(state); });
    information_->setMotionValidator(std::make_shared<ExactMotions>(information_, check_));
    information_->setup();
    problem_ = std::make_shared<ob::ProblemDefinition>(information_);
    const auto goals = std::make_shared<ob::GoalStates>(information_);
    ob::State* state = information_->allocState();
    coordinates.write(job.start, state);
    problem_->addStartState(state);
    for (const EntityConfiguration& goal : job.goals) {
      coordinates.write(goal, state);
      goals->addState(state);
    }
    information_->freeState(state);
    problem_->setGoal(goals);
    const double range = kind.range * space_->getMaximumExtent();
    planner_ = kind.method == SearchKind::Method::kRrtConnect ? makePlanner<og::RRTConnect>(information_, seed, range)
                                                              : makePlanner<og::BiEST>(information_, seed, range);
    planner_->setProblemDefinition(problem_);
    planner_->setup();
  }
  OneSearch(const OneSearch&) = delete;
  OneSearch& operator=(const OneSearch&) = delete;

  /// Goes on until it has made `most` checks in all, or `ends` says so.
  void run(const SearchJob& job, std::size_t most, const std::function<bool(std::size_t checks)>& ends) {
    const ob::PlannerTerminationCondition condition([&] { return check_.checks() >= most || ends(check_.checks()); });
    planner_->solve(condition);
    if (!problem_->hasExactSolution()) return;
    const auto* path = problem_->getSolutionPath()->as<og::PathGeometric>();
    for (std::size_t i = 0; i < path->getStateCount(); ++i) {
      path_.push_back(coordinates_.read(path->getState(static_cast<unsigned>(i))));
    }
    setEnds(job);
  }

  const std::vector<EntityConfiguration>& path() const { return path_; }
  std::size_t checks() const { return check_.checks(); }
  const SpaceCheck& check() const { return check_; }
  const char* name() const { return toString(kind_.method); }

  /// Of what was reached from the start, what is nearest to a goal.
  std::optional<EntityConfiguration> nearest(const SearchJob& job) const {
    ob::PlannerData data(information_);
    planner_->getPlannerData(data);
    std::optional<EntityConfiguration> best;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned i = 0; i < data.numVertices(); ++i) {
      constexpr int kOfStart = 1;  // Tags of planners with two trees.
      if (data.getVertex(i).getTag() != kOfStart) continue;
      EntityConfiguration at = coordinates_.read(data.getVertex(i).getState());
      for (const EntityConfiguration& goal : job.goals) {
        const double distance = coordinates_.distance(at, goal);
        if (distance >= least) continue;
        least = distance;
        best = at;
      }
    }
    return best;
  }

 private:
  /// The ends as they were given, without the rounding of the coordinates.
  void setEnds(const SearchJob& job) {
    path_.front() = job.start;
    path_.back() = *std::min_element(job.goals.begin(), job.goals.end(), [&](const auto& a, const auto& b) {
      return coordinates_.distance(path_.back(), a) < coordinates_.distance(path_.back(), b);
    });
  }

  const Coordinates& coordinates_;
  SpaceCheck check_;
  SearchKind kind_;
  ob::StateSpacePtr space_;
  ob::SpaceInformationPtr information_;
  ob::ProblemDefinitionPtr problem_;
  ob::PlannerPtr planner_;
  std::vector<EntityConfiguration> path_;
};

/// By `planning_bench kinds` (docs/dev/performance.md): of single searches, 0.05 is the best at the 99th percentile. Half
/// the ranges: as fast, more checks; twice: twice the time.
std::vector<SearchKind> shippedKinds() {
  using Method = SearchKind::Method;
  return {
      {Method::kRrtConnect, 0.05}, {Method::kRrtConnect, 0.03}, {Method::kRrtConnect, 0.05}, {Method::kRrtConnect, 0.1}};
}

/// The searches of one job and their rounds.
class Race {
 public:
  Race(const FreeSpace& space, const SearchJob& job)
      : space_(space), job_(job), coordinates_(space, job), kinds_(job.kinds) {
    if (kinds_.empty()) kinds_ = shippedKinds();
  }

  void run(SearchResult& result) {
    for (std::size_t round = 0, most = kFirstRound; winner_ == kNone; ++round, most *= 2) {
      const std::size_t budget = std::min(most, job_.most_checks);
      const std::size_t wanted = std::min(kinds_.size(), round == 0 ? 1 : 1 + round * kSearchesARound);
      while (searches_.size() < wanted) addSearch();
      runRound(budget);
      if (job_.progress) job_.progress(static_cast<double>(budget) / static_cast<double>(job_.most_checks));
      if (isOver() || (budget == job_.most_checks && searches_.size() == kinds_.size())) break;
    }
    result.blocks = searches_.front()->check().blocks();
    if (winner_ == kNone) {
      result.nearest = searches_.front()->nearest(job_);
      for (const auto& search : searches_) result.checks += search->checks();
      return;
    }
    result.path = searches_[winner_]->path();
    result.checks = searches_[winner_]->checks();
    result.planner = searches_[winner_]->name();
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  void addSearch() {
    const std::size_t number = searches_.size();
    std::seed_seq sequence{static_cast<std::uint32_t>(job_.seed), static_cast<std::uint32_t>(job_.seed >> 32),
                           static_cast<std::uint32_t>(number)};
    std::uint32_t seeds[2];
    sequence.generate(seeds, seeds + 2);
    const std::uint64_t seed = (std::uint64_t{seeds[0]} << 32 | seeds[1]) | 1;
    searches_.push_back(std::make_unique<OneSearch>(space_, coordinates_, job_, kinds_[number], seed));
  }

  bool isOver() const {
    return (job_.stop != nullptr && job_.stop->load(std::memory_order_relaxed)) ||
           std::chrono::steady_clock::now() >= job_.deadline;
  }

  /// Whether the first has used no fewer checks than the other: then it cannot win.
  struct Score {
    std::size_t checks = kNone, search = kNone;
    bool operator<(const Score& other) const {
      return checks != other.checks ? checks < other.checks : search < other.search;
    }
  };

  void runRound(std::size_t budget) {
    Score best;
    std::mutex mutex;
    const auto one = [&](std::size_t number) {
      OneSearch& search = *searches_[number];
      search.run(job_, budget, [&](std::size_t checks) {
        if (isOver()) return true;
        const std::lock_guard lock(mutex);
        return best < Score{checks, number};
      });
      if (search.path().empty()) return;
      const std::lock_guard lock(mutex);
      best = std::min(best, Score{search.checks(), number});
    };
    const std::size_t threads = std::min(searches_.size(), static_cast<std::size_t>(std::max(1, job_.threads)));
    std::atomic<std::size_t> next{0};
    geometry::inRanges(threads, threads, [&](std::size_t, std::size_t, std::size_t) {
      for (std::size_t number = next++; number < searches_.size(); number = next++) one(number);
    });
    winner_ = best.search;
  }

  const FreeSpace& space_;
  const SearchJob& job_;
  const Coordinates coordinates_;
  std::vector<SearchKind> kinds_;
  std::vector<std::unique_ptr<OneSearch>> searches_;
  std::size_t winner_ = kNone;
};

}  // namespace

const char* toString(SearchKind::Method method) {
  return method == SearchKind::Method::kRrtConnect ? "rrt_connect" : "bi_est";
}

SearchResult search(const FreeSpace& space, const SearchJob& job) {
  HAPTICELL_DEMAND(!job.goals.empty());
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  SearchResult result;
  FreeSpace own = space.fresh();
  for (const EntityConfiguration& goal : job.goals) {
    if (!own.isFree(job.start, goal)) continue;
    result.path = {job.start, goal};
    result.planner = "straight";
    result.checks = own.checks();
    return result;
  }
  Race(space, job).run(result);
  result.checks += own.checks();
  return result;
}

}  // namespace hapticell::planning
