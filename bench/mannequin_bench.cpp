// SPDX-License-Identifier: Apache-2.0
// Measures the mannequin: forward kinematics, cold and near solves, drags. Prints a table for docs/performance.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "bench/mannequin_goals.h"
#include "mannequin/joint_limits.h"
#include "mannequin/support_polygon.h"

namespace {

using namespace hapticell;
using namespace hapticell::mannequin;

/// Time that this thread has had a processor: what a loaded machine leaves comparable.
struct Clock {
  using time_point = double;
  static time_point now() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
  }
};

double microseconds(Clock::time_point begin) {
  return Clock::now() - begin;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(q * static_cast<double>(values.size())))];
}

void measureKinematics(const Figure& figure) {
  std::mt19937_64 random(1);
  const Posture posture = bench::makeGoal(figure, {}, random).reached;
  FigurePose pose;
  double best_fk = 1e9, best_both = 1e9;
  volatile double sink = 0.0;
  for (int repeat = 0; repeat < 20; ++repeat) {
    auto begin = Clock::now();
    for (int i = 0; i < 5000; ++i) forwardKinematics(figure, posture, pose);
    best_fk = std::min(best_fk, microseconds(begin) / 5000);
    begin = Clock::now();
    for (int i = 0; i < 5000; ++i) {
      forwardKinematics(figure, posture, pose);
      sink = sink + centerOfMass(figure, pose).z;
    }
    best_both = std::min(best_both, microseconds(begin) / 5000);
  }
  std::printf("forward kinematics %.3f us, with centre of mass %.3f us (minima of 20)\n", best_fk, best_both);
}

Posture nearPosture(const Posture& reached, std::mt19937_64& random) {
  Posture near = reached;
  const auto small = [&] { return (static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5) * 4.0 * M_PI / 180.0; };
  for (std::size_t i = 0; i < indexOf(Dof::kLeftHipFlexion); ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    near.angles[i] += small();
    if (!isCoupled(static_cast<Dof>(i))) near.angles[i] = std::clamp(near.angles[i], info.lower, info.upper);
  }
  return near;
}

void measureSolves(const Figure& figure, const char* name, const bench::GoalOptions& options, int count, bool near) {
  std::mt19937_64 random(7);
  const PostureSolver solver(figure);
  std::vector<double> times;
  int solved = 0, iterations = 0;
  double worst_limit = 0.0;
  std::vector<double> tries;
  for (int i = 0; i < count; ++i) {
    const bench::ReachableGoal goal = bench::makeGoal(figure, options, random);
    const Posture start = near ? nearPosture(goal.reached, random) : goal.neutral;
    const auto begin = Clock::now();
    const PostureResult result = solver.solve(goal.task, start);
    times.push_back(microseconds(begin));
    solved += result.status == PostureStatus::kSolved ? 1 : 0;
    iterations += result.iterations;
    tries.push_back(result.tries);
    worst_limit = std::max(worst_limit, limitViolations(result.posture).empty() ? 0.0 : 1.0);
  }
  std::printf(
      "%-34s %6d goals  %6.2f %%  median %7.1f  p99 %7.1f us  iterations %.1f  tries p50/p99 %.0f/%.0f  limits broken: "
      "%s\n",
      name, count, 100.0 * solved / count, quantile(times, 0.5), quantile(times, 0.99),
      static_cast<double>(iterations) / count, quantile(tries, .5), quantile(tries, .99),
      worst_limit > 0 ? "YES" : "no");
}

/// One hand along straight lines, 1 mm a tick; with `away` straight out of the reach.
void measureDrag(const Figure& figure, const char* name, bool two_hands, bool lock_trunk, double away, int paths) {
  std::mt19937_64 random(11);
  const PostureSolver solver(figure);
  std::vector<double> times;
  double foot = 0.0, swing = 0.0;
  for (int p = 0; p < paths; ++p) {
    const bench::ReachableGoal a = bench::makeGoal(figure, {0.6, false}, random);
    const bench::ReachableGoal b = bench::makeGoal(figure, {0.6, false}, random);
    Posture posture = a.reached;
    PostureTask task;
    task.trunk_locked = lock_trunk;
    task.feet = a.task.feet;
    FigurePose before = forwardKinematics(figure, posture);
    const Pose stood = footPose(before, Side::kLeft);
    const dvec3 way = away > 0.0 ? away * glm::normalize(a.task.hands[1]->p - posture.X_WR.p)
                                 : b.task.hands[1]->p - a.task.hands[1]->p;
    const int ticks = static_cast<int>(glm::length(way) / 1e-3);
    for (int t = 1; t <= ticks; ++t) {
      for (std::size_t i = two_hands ? 0 : 1; i < 2; ++i) {
        task.hands[i] = *a.task.hands[i];
        task.hands[i]->p += way * (static_cast<double>(t) / ticks);
      }
      const auto begin = Clock::now();
      const PostureResult result = solver.follow(task, posture);
      times.push_back(microseconds(begin));
      const FigurePose after = forwardKinematics(figure, result.posture);
      foot = std::max(foot, glm::length(footPose(after, Side::kLeft).p - stood.p));
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const Dof elbow = armDof(side, Dof::kLeftElbowFlexion);
        swing = std::max(swing, std::abs(result.posture[elbow] - posture[elbow]));
      }
      posture = result.posture;
      before = after;
    }
  }
  std::printf("%-34s %6zu ticks  median %7.1f  p99 %7.1f us  elbow step %.2f deg  feet %.3f mm\n", name, times.size(),
              quantile(times, 0.5), quantile(times, 0.99), swing * 180.0 / M_PI, 1000.0 * foot);
}

void measureFourSizes() {
  const std::vector<NamedFigure> figures = boundaryFigures();
  std::mt19937_64 random(13);
  std::vector<double> times;
  for (int i = 0; i < 200; ++i) {
    const bench::ReachableGoal goal = bench::makeGoal(figures[2].figure, {0.5, false}, random);
    PostureTask task;
    task.hands[1] = goal.task.hands[1];
    const auto begin = Clock::now();
    for (const NamedFigure& named : figures) {
      const Posture standing = *libraryPosture(named.figure, "standing");
      PostureSolver(named.figure).solve(task, standing);
    }
    times.push_back(microseconds(begin));
  }
  std::printf("four sizes for one target: median %.0f us, p99 %.0f us\n", quantile(times, 0.5), quantile(times, 0.99));
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 2000;
  const Expected<Figure> figure = makeFigure({Sex::kMale, *statureOfPercentile(Sex::kMale, 50)});
  measureKinematics(*figure);
  measureSolves(*figure, "cold, parallel feet, full limits", {1.0, false}, count, false);
  measureSolves(*figure, "cold, parallel feet, 70 %", {0.7, false}, count, false);
  measureSolves(*figure, "cold, split stance, full limits", {1.0, true}, count, false);
  measureSolves(*figure, "near, parallel feet", {1.0, false}, count, true);
  measureDrag(*figure, "drag, one hand", false, false, 0.0, 20);
  measureDrag(*figure, "drag, one hand, trunk locked", false, true, 0.0, 20);
  measureDrag(*figure, "drag, one hand, out of reach", false, false, 1.0, 10);
  measureDrag(*figure, "drag, two hands", true, false, 0.0, 20);
  measureFourSizes();
  return 0;
}
