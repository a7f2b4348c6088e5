// SPDX-License-Identifier: Apache-2.0
// A hand that only knows the straight way, a planner, and both together: how often and how soon they solve a move.
//
// usage: assisted_bench [extraction] [puzzle] [pipe] [robot] [runs=10] [first=1] [limit=40] [full] [together] [planner] [hand]
// together, planner, hand: these modes alone; without any of them, all three.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/assisted_scenes.h"
#include "manipulation/session/session.h"
#include "planning/live/live_planner.h"

namespace hapticell::bench {
namespace {

/// Knows the goal and no way: what a session of the hand alone needs.
class GoalOnly final : public manipulation::PlanSource {
 public:
  explicit GoalOnly(planning::Goal goal) : goal_(std::move(goal)) {}
  void look(const manipulation::PlanView&) override {}
  std::shared_ptr<const manipulation::PlannedWay> newest() override { return nullptr; }
  bool isReached(const manipulation::PlanView& view) const override {
    return planning::isAtGoal(goal_, view.X_WM, view.standing.joints, {}, 0.0);
  }

 private:
  planning::Goal goal_;
};

struct Tried {
  int runs = 0, solved = 0;
  std::vector<double> seconds;      ///< Of those that were solved.
  double most_step = 0.0, least_energy = 0.0, inside = 0.0;
  double most_led = 0.0;            ///< N/ms from 50 ms after a contact changed on, as M1 of docs/dev/feel.md.
  double most_pull = 0.0;           ///< N/ms of pulls alone, at all times.
  std::uint64_t ways = 0, insistences = 0;

  void add(bool is_solved, double time) {
    ++runs;
    if (!is_solved) return;
    ++solved;
    seconds.push_back(time);
  }
  /// With what was not solved as longer than all.
  double median(double limit) {
    std::sort(seconds.begin(), seconds.end());
    const auto middle = static_cast<std::size_t>(runs / 2);
    return middle < seconds.size() ? seconds[middle] : limit;
  }
};

/// The largest change of the force in a millisecond, with impacts left out as M1 does.
class ForceSteps {
 public:
  void add(const manipulation::TraceRow& row) {
    if (row.contact != contact_) changed_ = row.t;
    contact_ = row.contact;
    const dvec3 step_D = row.force_D - last_.force_D, pull_D = row.pull_D - last_.pull_D;
    const double hand = glm::distance(row.X_DS.p, last_.X_DS.p), proxy = glm::distance(row.X_DP.p, last_.X_DP.p);
    last_ = row;
    most_pull_ = std::max(most_pull_, glm::length(pull_D));
    if (row.t <= changed_ + kAfterChange || glm::length(step_D) <= most_) return;
    most_ = glm::length(step_D), most_t_ = row.t;
    contact_at_most_ = glm::length(step_D - pull_D), pull_at_most_ = glm::length(pull_D);
    hand_at_most_ = 1e3 * hand, proxy_at_most_ = 1e3 * proxy;
  }
  double most() const { return most_; }
  double when() const { return most_t_; }
  /// Of pulls alone, at all times.
  double mostOfPulls() const { return most_pull_; }
  /// What contacts and pulls made of the largest.
  double contactAtMost() const { return contact_at_most_; }
  double pullAtMost() const { return pull_at_most_; }
  /// m/s of stylus and proxy then.
  double handAtMost() const { return hand_at_most_; }
  double proxyAtMost() const { return proxy_at_most_; }

 private:
  static constexpr double kAfterChange = 0.05;  // s, as feel_session.cpp.
  bool contact_ = false;
  double changed_ = -1.0, most_ = 0.0, most_t_ = 0.0, most_pull_ = 0.0;
  double contact_at_most_ = 0.0, pull_at_most_ = 0.0, hand_at_most_ = 0.0, proxy_at_most_ = 0.0;
  manipulation::TraceRow last_;
};

/// s that a check counts for: by counts, not by the clock, so that every run gives the same figures. 100 us is between
/// those of the solids and of the robot. Half and twice: half and twice of the delay.
constexpr double kCheckTime = 100e-6;
/// LiveOptions::most_checks. Half: searches of the puzzle that would find a way are ended; twice: one that finds none
/// takes the rest of the session.
constexpr std::size_t kMostChecks = 50'000;

struct Limits {
  int runs = 10, first = 1;
  double seconds = 40.0;
  bool planner = false, hand = false, together = false;  ///< None: all.
};

void handle(const AssistedScene& scene, std::uint64_t seed, double limit,
            const std::shared_ptr<manipulation::PlanSource>& planner, Tried& tried) {
  manipulation::SessionOptions options;
  options.entities = scene.entities;
  options.pairs = scene.pairs;
  options.entity = scene.entity;
  options.configuration.manipulation.rate_hz = scene.rate_hz;
  options.configuration.manipulation.edge_drift = 0.1;
  options.axes.mode = manipulation::AxesMode::kCell;
  options.scale = {manipulation::ScaleLevel::kNumber, scene.scale};
  manipulation::StraightHandOptions hand = manipulation::seededHand(seed);
  hand.X_WG = scene.X_WG;
  hand.scale = scene.scale;
  options.straight_hand = hand;
  const dvec3 way = [&] {
    for (const workcell::Entity& entity : scene.entities)
      if (entity.name == scene.entity && !entity.robot()) return scene.X_WG.p - entity.X_WE.p;
    return dvec3(0.0);
  }();
  const Pose X_DStart = Pose::translation(-0.5 * way / scene.scale);
  options.hand = haptic::HandPath({{0.0, X_DStart, 0}, {limit, X_DStart, 0}});
  options.assistance = {planner, 1.0};
  ForceSteps steps;
  const char* const tells = std::getenv("ASSISTED_TELLS");
  const auto trace = [&](const manipulation::TraceRow& row) {
    steps.add(row);
    if (tells == nullptr || tells[0] != '2' || std::lround(1e3 * row.t) % 500 != 0) return;
    std::fprintf(stderr, "    %.1f s: %.3f %.3f %.3f (%.2f %.2f %.2f %.2f) force %.2f %.2f %.2f %s\n", row.t, row.X_WM.p.x,
                 row.X_WM.p.y, row.X_WM.p.z, row.X_WM.q.w, row.X_WM.q.x, row.X_WM.q.y, row.X_WM.q.z, row.force_D.x,
                 row.force_D.y, row.force_D.z, row.contact ? "contact" : "");
  };
  const std::clock_t begin = std::clock();
  const auto report = manipulation::runSession(options, trace);
  if (!report) {
    std::fprintf(stderr, "%s\n", report.error().message().c_str());
    std::exit(2);
  }
  tried.add(report->plan->solved, report->plan->solved_s);
  tried.most_step = std::max(tried.most_step, report->forces.force_max_step_n_per_ms);
  tried.most_led = std::max(tried.most_led, steps.most());
  tried.most_pull = std::max(tried.most_pull, steps.mostOfPulls());
  tried.least_energy = std::min(tried.least_energy, report->forces.energy_min_j);
  tried.inside = std::max(tried.inside, report->forces.penetration_blocked_m);
  tried.ways += report->plan->ways;
  tried.insistences += report->plan->insistences;
  if (tells != nullptr) {
    std::fprintf(stderr,
                 "  seed %llu: %.2f s, %.3f N/ms at %.3f s (contacts %.3f, pulls %.3f; stylus %.3f, proxy %.3f m/s; "
                 "%.3f with impacts; pulls alone %.3f), %.3f mJ, %.1f s of a processor\n",
                 static_cast<unsigned long long>(seed), report->plan->solved_s, steps.most(), steps.when(),
                 steps.contactAtMost(), steps.pullAtMost(), steps.handAtMost(), steps.proxyAtMost(),
                 report->forces.force_max_step_n_per_ms, steps.mostOfPulls(),
                 1e3 * report->forces.energy_min_j, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  if (!report->plan->solved && tells != nullptr) {
    const Pose& X = report->end.X_WM;
    std::fprintf(stderr, "  seed %llu ends at %.3f %.3f %.3f (%.2f %.2f %.2f %.2f), %llu ways\n",
                 static_cast<unsigned long long>(seed), X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z,
                 static_cast<unsigned long long>(report->plan->ways));
  }
}

/// The planner alone, as the command plan does it.
void planAlone(const AssistedScene& scene, std::uint64_t seed, double limit, Tried& tried) {
  planning::Problem problem;
  problem.scene = manipulation::PreparedScene::prepare(scene.entities, scene.pairs, {});
  problem.entity = problem.scene->find(scene.entity)->id;
  problem.goal = scene.goal;
  problem.clearance = scene.clearance;
  problem.seed = seed;
  problem.time_limit_s = limit;
  problem.most_checks = 100'000'000;
  const auto planned = planning::plan(problem);
  if (!planned) {
    std::fprintf(stderr, "%s\n", planned.error().message().c_str());
    std::exit(2);
  }
  tried.add(planned->isSolved(), planned->seconds);
  if (!planned->isSolved() && std::getenv("ASSISTED_TELLS"))
    std::fprintf(stderr, "  planner, seed %llu: %s\n", static_cast<unsigned long long>(seed),
                 english(planned->failure->reason).c_str());
}

void compare(const std::function<AssistedScene(std::uint64_t)>& make, const Limits& limits) {
  Tried hand, planner, both;
  std::string name;
  for (int run = 0; run < limits.runs; ++run) {
    const auto seed = static_cast<std::uint64_t>(run + limits.first);
    const AssistedScene scene = make(seed);
    name = scene.name;
    if (limits.planner) planAlone(scene, seed, limits.seconds, planner);
    if (limits.hand) handle(scene, seed, limits.seconds, std::make_shared<GoalOnly>(scene.goal), hand);
    if (limits.together) {
      planning::LiveOptions live;
      live.goal = scene.goal;
      live.clearance = scene.clearance;
      live.seed = seed;
      live.most_checks = kMostChecks;
      live.in_virtual_time = true;
      std::size_t most_found = 0, most_failed = 0;
      live.cost_s = [&](const planning::PlanResult& result) {
        std::size_t& most = result.isSolved() ? most_found : most_failed;
        most = std::max(most, result.checks);
        return kCheckTime * static_cast<double>(result.checks);
      };
      const auto planner_beside = std::make_shared<planning::LivePlanner>(std::move(live));
      handle(scene, seed, limits.seconds, planner_beside, both);
      if (std::getenv("ASSISTED_TELLS")) {
        const planning::LivePlanner::Figures figures = planner_beside->figures();
        std::fprintf(stderr, "  seed %llu: %llu searches, %llu found, %llu given; checks at most %zu "
                     "(found), %zu (not)%s%s\n",
                     static_cast<unsigned long long>(seed), static_cast<unsigned long long>(figures.searches),
                     static_cast<unsigned long long>(figures.found), static_cast<unsigned long long>(figures.given), most_found, most_failed,
                     figures.failure ? ": " : "", figures.failure ? english(figures.failure->reason).c_str() : "");
      }
    }
    std::fprintf(stderr, "%s %d: planner %d, hand %d, both %d of %d\n", name.c_str(), run + 1, planner.solved,
                 hand.solved, both.solved, run + 1);
  }
  const auto cell = [&](Tried& tried) {
    char text[64];
    std::snprintf(text, sizeof text, "%d of %d, %.2f s", tried.solved, tried.runs, tried.median(limits.seconds));
    return tried.runs > 0 ? std::string(text) : std::string("-");
  };
  std::printf("| %s | %s | %s | %s | %.1f | %.1f | %.3f / %.3f | %.3f / %.3f | %.3f | %.2f / %.2f |\n", name.c_str(),
              cell(hand).c_str(), cell(planner).c_str(), cell(both).c_str(), static_cast<double>(both.ways) / std::max(1, both.runs),
              static_cast<double>(both.insistences) / std::max(1, both.runs), hand.most_led, both.most_led,
              hand.most_step, both.most_step, both.most_pull, 1e3 * hand.least_energy, 1e3 * both.least_energy);
  std::fflush(stdout);
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  Limits limits;
  std::vector<std::string> wanted;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (const std::string& word : words) {
    if (word == "full") limits.runs = 100;
    else if (word.starts_with("runs=")) limits.runs = std::max(1, std::atoi(word.c_str() + 5));
    else if (word.starts_with("first=")) limits.first = std::max(1, std::atoi(word.c_str() + 6));
    else if (word == "together") limits.together = true;
    else if (word == "planner") limits.planner = true;
    else if (word == "hand") limits.hand = true;
    else if (word.starts_with("limit=")) limits.seconds = std::max(1.0, std::atof(word.c_str() + 6));
    else wanted.push_back(word);
  }
  if (!limits.planner && !limits.hand && !limits.together) limits.planner = limits.hand = limits.together = true;
  if (wanted.empty()) wanted = {"extraction", "puzzle", "pipe", "robot"};
  std::printf("| scene | hand alone | planner alone | hand and planner | ways | insisted | N/ms, hand / both "
              "| with impacts | pulls | mJ, hand / both |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& one : wanted) {
    if (one == "extraction") compare([](std::uint64_t) { return extractionScene(); }, limits);
    if (one == "puzzle") compare([](std::uint64_t) { return wirePuzzleScene(); }, limits);
    if (one == "pipe") compare([](std::uint64_t) { return bentPipeScene(); }, limits);
    if (one == "robot") compare([](std::uint64_t seed) { return robotScene(seed); }, limits);
  }
  return 0;
}
