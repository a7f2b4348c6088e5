// SPDX-License-Identifier: Apache-2.0
// Measures the mannequin: forward kinematics, cold and near solves, drags, a held object, recorded motions of which
// only hands and feet are told. Prints a table for docs/dev/performance.md. usage: mannequin_bench [GOALS [MOTION...]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "bench/mannequin_goals.h"
#include "bench/mannequin_recorded.h"
#include "geometry/system/percentile.h"
#include "mannequin/body/joint_limits.h"
#include "mannequin/posture/support_polygon.h"

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
  const auto small = [&] {
    return (static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5) * 4.0 * std::numbers::pi / 180.0;
  };
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
      name, count, 100.0 * solved / count, percentile(times, 0.5), percentile(times, 0.99),
      static_cast<double>(iterations) / count, percentile(tries, .5), percentile(tries, .99),
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
              percentile(times, 0.5), percentile(times, 0.99), swing * 180.0 / std::numbers::pi, 1000.0 * foot);
}

/// An object between both hands, 1 to 2 mm a tick along lines that lead out of reach: what the hands slip on it.
void measureHeldObject(const Figure& figure, int paths) {
  std::mt19937_64 random(17);
  const PostureSolver solver(figure);
  std::vector<double> times;
  double slip = 0.0, turn = 0.0;
  int beyond = 0;
  for (int p = 0; p < paths; ++p) {
    const bench::ReachableGoal a = bench::makeGoal(figure, {0.6, false}, random);
    const bench::ReachableGoal b = bench::makeGoal(figure, {1.0, false}, random);
    Posture posture = a.reached;
    const FigurePose start = forwardKinematics(figure, posture);
    const Pose left = handPose(start, Side::kLeft), right = handPose(start, Side::kRight);
    const Pose X_LR = left.inverse() * right;
    const Pose X_WO{0.5 * (left.p + right.p), dquat(1, 0, 0, 0)};
    PostureTask task;
    task.feet = a.task.feet;
    const dvec3 way = 1.5 * glm::normalize(b.task.hands[1]->p - right.p + dvec3(1e-6, 0, 0));
    for (int t = 1; t <= 1000; ++t) {
      HeldObject held{X_WO, {X_WO.inverse() * left, X_WO.inverse() * right}};
      held.X_WO.p += way * (static_cast<double>(t) / 1000.0);
      task.held = held;
      const auto begin = Clock::now();
      const PostureResult result = solver.follow(task, posture);
      times.push_back(microseconds(begin));
      posture = result.posture;
      beyond += result.status == PostureStatus::kOutOfReach ? 1 : 0;
      const FigurePose now = forwardKinematics(figure, posture);
      const Twist off = difference(handPose(now, Side::kLeft).inverse() * handPose(now, Side::kRight), X_LR);
      slip = std::max(slip, glm::length(off.linear));
      turn = std::max(turn, glm::length(off.angular));
    }
  }
  std::printf("%-34s %6zu ticks  median %7.1f  p99 %7.1f us  slip %.1e m, %.1e rad at most; out of reach %d %%\n",
              "drag, held object", times.size(), percentile(times, 0.5), percentile(times, 0.99), slip, turn,
              static_cast<int>(100 * beyond / static_cast<int>(times.size())));
}

void measureRecorded(const char* file) {
  const Expected<MotionClip> clip = readMotionFile(file);
  if (!clip) {
    std::printf("%s\n", clip.error().message().c_str());
    return;
  }
  const Expected<Figure> figure = makeFigure({Sex::kMale, 1.755});
  const bench::RecordedError error = bench::replayHandsAndFeet(*figure, *clip);
  const std::string path(file), name = path.substr(path.find_last_of('/') + 1);
  std::printf(
      "hands and feet of %-14s %6d frames  median %7.1f us  trunk %.1f deg (axis %.1f)  swivel %.1f deg  elbow %.0f mm "
      " hand "
      "%.1f mm at most\n",
      name.c_str(), error.frames, error.median_us, error.trunk_deg, error.trunk_axis_deg, error.swivel_deg,
      error.elbow_mm, error.worst_hand_mm);
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
  std::printf("four sizes for one target: median %.0f us, p99 %.0f us\n", percentile(times, 0.5),
              percentile(times, 0.99));
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
  measureHeldObject(*figure, 20);
  measureFourSizes();
  for (int k = 2; k < argc; ++k) measureRecorded(argv[k]);
  return 0;
}
