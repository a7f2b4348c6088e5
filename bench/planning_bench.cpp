// SPDX-License-Identifier: Apache-2.0
// Plans of a chain of seven joints among 80 parts of 20,000 triangles (scene_bench's chain), beside FCL's broad phase
// under the same planner of OMPL in the same process. Prints a table of docs/dev/performance.md.
//
// usage: planning_bench [problems] [kinds] [peer] [written]
// Default: 100 problems; kinds: each search alone; peer: with FCL; written: motions are written and measured too.
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "bench/chain_robot.h"
#include "bench/collision_scenes.h"
#include "geometry/system/percentile.h"
#include "planning/plan.h"
#include "planning/search.h"
#include "planning/timed_plan.h"
#include "planning/written_plan.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"
#ifdef HAPTICELL_HAS_FCL
#include "bench/fcl_peer.h"
#endif

namespace hapticell::bench {
namespace {

using Angles = std::vector<double>;
constexpr double kClearance = 0.005;
constexpr double kPeerLimit = 20.0;  // s: then the peer gives a problem up.
// What ends a plan here: checks. Of clock time there is more than the busiest machine needs.
constexpr std::size_t kMostChecks = 20'000;
constexpr double kNoLimit = 3600.0;  // s
// Of a search that tells whether a problem without a plan has a solution: checks of each of its searches.
constexpr std::size_t kLongSearch = 100'000;

/// Processor time of all threads: other programs on the machine do not count.
double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Cell {
  Chain chain;
  std::vector<PlacedPart> parts;
  std::shared_ptr<const manipulation::PreparedScene> scene;
};

Cell makeCell() {
  Cell cell{makeChain(600), {}, nullptr};
  cell.parts = partsAround(cell.chain, 80, 20000);
  std::vector<workcell::Entity> entities{chainRobot(cell.chain)};
  // All of one shape, which is prepared once.
  const auto shape = std::make_shared<const geometry::TriangleMesh>(cell.parts.front().mesh);
  for (std::size_t i = 0; i < cell.parts.size(); ++i) {
    workcell::Entity part;
    part.id = 2 + i;
    part.name = "part" + std::to_string(i);
    part.body = workcell::Solid{shape};
    part.X_WE = cell.parts[i].X_WP;
    entities.push_back(std::move(part));
  }
  cell.scene = manipulation::PreparedScene::prepare(std::move(entities), {}, {});
  return cell;
}

/// Pairs of free postures, one after the other.
class Problems {
 public:
  explicit Problems(planning::FreeSpace space) : space_(std::move(space)) { space_.setClearance(1.1 * kClearance); }

  std::pair<Angles, Angles> next() {
    Angles start = posture();
    Angles goal = posture();
    return {std::move(start), std::move(goal)};
  }

  std::vector<std::pair<Angles, Angles>> next(std::size_t count) {
    std::vector<std::pair<Angles, Angles>> problems;
    while (problems.size() < count) problems.push_back(next());
    return problems;
  }

 private:
  Angles posture() {
    while (true) {
      planning::EntityConfiguration at = space_.present();
      for (std::size_t i = 0; i < at.joints.size(); ++i) at.joints[i] = i % 2 == 0 ? turn_(random_) : bend_(random_);
      if (space_.isFree(at)) return at.joints;
    }
  }

  planning::FreeSpace space_;
  std::mt19937 random_{29};
  std::uniform_real_distribution<double> turn_{-2.5, 2.5}, bend_{-1.2, 1.2};
};

/// Whether long searches of both kinds from both ends, with seeds that the planner does not have, join two postures
/// with the bare clearance. That they do not is no proof that nothing does, but the best that sampling can say.
bool joinedByLongSearch(const planning::FreeSpace& given, const std::pair<Angles, Angles>& problem) {
  using Method = planning::SearchKind::Method;
  planning::FreeSpace space = given.fresh();
  space.setClearance(kClearance);
  planning::SearchJob job;
  job.start = {space.present().X_WE, problem.second};
  job.goals = {{space.present().X_WE, problem.first}};
  job.seed = 77;
  job.most_checks = kLongSearch;
  job.kinds = {{Method::kBiEst, 0.05}, {Method::kRrtConnect, 0.02}, {Method::kRrtConnect, 0.4}, {Method::kBiEst, 0.2}};
  return !planning::search(space, job).path.empty();
}

void row(const std::string& name, std::vector<double> times, std::size_t solved, const std::string& note) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("| %s | %zu of %zu | %.1f / %.1f / %.1f | %s |\n", name.c_str(), solved, times.size(), 1e3 * at(0.5),
              1e3 * at(0.99), 1e3 * times.back(), note.c_str());
  std::fflush(stdout);
}

planning::Problem problemOf(const Cell& cell, const planning::FreeSpace& space, const std::pair<Angles, Angles>& ends) {
  planning::Problem problem;
  problem.scene = cell.scene;
  problem.entity = 1;
  problem.start = planning::EntityConfiguration{space.present().X_WE, ends.first};
  problem.goal = planning::goal::ToJoints{ends.second};
  problem.clearance = kClearance;
  problem.most_checks = kMostChecks;
  problem.time_limit_s = kNoLimit;
  return problem;
}

/// The written motions of plans, measured as `hapticell-cli plan` does.
struct Written {
  std::string file = "/tmp/planning_bench." + std::to_string(static_cast<long>(1e3 * seconds())) + ".htraj";
  std::size_t kept = 0;
  double least = 1.0;

  void add(const planning::Plan& plan, const Cell& cell, const planning::FreeSpace& space) {
    for (const double rounding : {1.0, 0.4, 0.1}) {
      const auto motion = planning::timedMotion(plan, space, {.rounding = rounding});
      if (!motion || !workcell::writeFileAtomically(file, trajectory::toJsonText(*motion))) continue;
      const auto promises = planning::writtenPlanPromises(std::filesystem::path(file), plan, kClearance, cell.scene, 1);
      std::remove(file.c_str());
      if (!promises || !promises->areKept()) {
        std::fprintf(stderr, "rounded off by %.1f of the slack: %s\n", rounding,
                     (promises ? promises->missed("plan") : promises.error()).message().c_str());
        continue;
      }
      ++kept;
      least = std::min(least, promises->list.front().measured);
      return;
    }
    std::fprintf(stderr, "a written motion does not keep its promises\n");
  }

  std::string words() const {
    return std::to_string(kept) + " written motions keep 5 mm and all else, least " + std::to_string(1e3 * least) +
           " mm; ";
  }
};

/// Returns the problems that it counted. One that is not solved counts unless a long search does not join its ends
/// either: that one is named and another takes its place.
std::vector<std::pair<Angles, Angles>> measurePlans(const Cell& cell, const planning::FreeSpace& space,
                                                    std::size_t count, bool is_written) {
  Problems problems(space.fresh());
  std::vector<std::pair<Angles, Angles>> counted;
  std::vector<double> times;
  std::size_t solved = 0, straight = 0, checks = 0, apart = 0, drawn = 0;
  double length = 0.0;
  Written written;
  while (counted.size() < count) {
    const auto ends = problems.next();
    ++drawn;
    const planning::Problem problem = problemOf(cell, space, ends);
    const double begin = seconds();
    const auto result = planning::plan(problem, space);
    const double took = seconds() - begin;
    const bool is_solved = result && result->isSolved();
    std::fprintf(stderr, "%zu: %s, %.1f ms\n", drawn, is_solved ? result->planner.c_str() : "not solved", 1e3 * took);
    if (!is_solved && !joinedByLongSearch(space, ends)) {
      std::fprintf(stderr, "problem %zu: a long search does not join its ends either\n", drawn);
      ++apart;
      continue;
    }
    counted.push_back(ends);
    times.push_back(took);
    if (!is_solved) continue;
    ++solved;
    checks += result->checks;
    length += result->plan->length;
    straight += result->planner == "straight" ? 1 : 0;
    if (is_written) written.add(*result->plan, cell, space);
  }
  row("HaptiCell: searched, shortened, smoothed", times, solved,
      (is_written ? written.words() : "") + std::to_string(straight) + " straight; " +
          std::to_string(checks / std::max<std::size_t>(1, solved)) + " checks and " +
          std::to_string(length / static_cast<double>(std::max<std::size_t>(1, solved))) + " m each; " +
          std::to_string(apart) + " drawn problems that no long search joins either are not among them");
  return counted;
}

/// Each kind of search alone, one thread, without shortening.
void measureKinds(const planning::FreeSpace& given, const std::vector<std::pair<Angles, Angles>>& problems) {
  using Method = planning::SearchKind::Method;
  planning::FreeSpace space = given.fresh();
  space.setClearance(1.1 * kClearance);
  for (const Method method : {Method::kRrtConnect, Method::kBiEst}) {
    for (const double range : {0.02, 0.05, 0.1, 0.2, 0.4}) {
      std::vector<double> times;
      std::size_t solved = 0, checks = 0;
      for (const auto& [start, goal] : problems) {
        planning::SearchJob job;
        job.start = {space.present().X_WE, start};
        job.goals = {{space.present().X_WE, goal}};
        job.kinds = {{method, range}};
        job.most_checks = 20'000;
        const double begin = seconds();
        const auto result = planning::search(space, job);
        times.push_back(seconds() - begin);
        solved += result.path.empty() ? 0 : 1;
        checks += result.checks;
      }
      row(std::string(toString(method)) + " " + std::to_string(range), times, solved,
          std::to_string(checks / problems.size()) + " checks each");
    }
  }
}

#ifdef HAPTICELL_HAS_FCL
namespace ob = ompl::base;

/// RRT-Connect of OMPL with its default range, motions sampled every 0.02 rad, as MoveIt asks FCL.
void measurePeer(const Cell& cell, const std::vector<std::pair<Angles, Angles>>& problems) {
  std::vector<Pose> X_WS;
  std::vector<geometry::TriangleMesh> standing;
  for (const PlacedPart& part : cell.parts) {
    standing.push_back(part.mesh);
    X_WS.push_back(part.X_WP);
  }
  FclGroup peer(cell.chain.links, standing, X_WS);
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  std::vector<double> times;
  std::size_t solved = 0;
  for (const auto& [start, goal] : problems) {
    auto space = std::make_shared<ob::RealVectorStateSpace>(7);
    space->setBounds(-2.8, 2.8);
    ompl::geometric::SimpleSetup setup(space);
    setup.setStateValidityChecker([&](const ob::State* state) {
      const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
      return !peer.collides(chainPoses(Angles(values, values + 7)));
    });
    space->setLongestValidSegmentFraction(0.02 / space->getMaximumExtent());
    ob::ScopedState<> from(space), to(space);
    for (unsigned i = 0; i < 7; ++i) {
      from[i] = start[i];
      to[i] = goal[i];
    }
    setup.setStartAndGoalStates(from, to);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(setup.getSpaceInformation()));
    const double begin = seconds();
    const bool found = setup.solve(kPeerLimit) == ob::PlannerStatus::EXACT_SOLUTION;
    times.push_back(seconds() - begin);
    solved += found ? 1 : 0;
  }
  row("FCL, RRT-Connect of OMPL, no clearance, not shortened", times, solved, "0.02 rad between samples");
}
#endif

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  std::size_t count = 100;
  bool kinds = false, peer = false, written = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "kinds") {
      kinds = true;
    } else if (word == "peer") {
      peer = true;
    } else if (word == "written") {
      written = true;
    } else {
      count = static_cast<std::size_t>(std::max(1, std::atoi(word.c_str())));
    }
  }
  const Cell cell = makeCell();
  const auto space = hapticell::planning::FreeSpace::create(cell.scene, 1, {});
  if (!space) {
    std::fprintf(stderr, "%s\n", space.error().message().c_str());
    return 1;
  }
  std::printf("| planner | solved | processor time, ms (median / p99 / max) | |\n| --- | --- | --- | --- |\n");
  if (kinds) {
    measureKinds(*space, Problems(space->fresh()).next(count));
    return 0;
  }
  const auto problems = measurePlans(cell, *space, count, written);
#ifdef HAPTICELL_HAS_FCL
  if (peer) measurePeer(cell, problems);
#else
  (void)problems;
#endif
  return 0;
}
