// SPDX-License-Identifier: Apache-2.0
// How long the numeric inverse model takes; docs/performance.md, "Kinematics", quotes the figures.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "kinematics/numeric_inverse.h"
#include "tests/kinematics/test_robots.h"

namespace {

using namespace hapticell;
using namespace hapticell::kinematics;
using Clock = std::chrono::steady_clock;

void print(const char* robot, const char* what, std::vector<double>& us) {
  std::sort(us.begin(), us.end());
  std::printf("%-7s %-34s median %8.2f us   p99 %8.2f us   max %8.2f us\n", robot, what, us[us.size() / 2],
              us[us.size() * 99 / 100], us.back());
}

double microseconds(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

/// Paths of 100 samples at 1 kHz from random poses, 0.2 m/s and 0.4 rad/s, `offset_m` further out than the arm's pose.
void track(const char* robot, const char* what, const RobotModel& model, double offset_m) {
  const int tip = model.defaultTip();
  const auto inverse = NumericInverse::create(model, tip);
  std::mt19937_64 random(1);
  std::vector<double> us;
  InverseSolution solution;
  for (int path = 0; path < 200; ++path) {
    solution.q = test::randomJoints(model, random);
    Pose X_0 = test::tipPose(model, solution.q, tip);
    X_0.p += offset_m * glm::normalize(X_0.p);
    std::vector<double> q;
    for (int i = 0; i < 300; ++i) {
      const double t = i * 1e-3;
      const Pose X_BT = displaced(X_0, {t * dvec3(0.16, 0.1, 0.06), t * dvec3(0.2, 0.3, 0.17)});
      q = solution.q;
      const auto begin = Clock::now();
      (*inverse)->solveNearest(X_BT, q, 1e-3, solution);
      if (i >= 200) us.push_back(microseconds(begin));
    }
  }
  print(robot, what, us);
}

void cold(const char* robot, const RobotModel& model) {
  const int tip = model.defaultTip();
  const auto inverse = NumericInverse::create(model, tip);
  std::mt19937_64 random(2);
  std::vector<double> one_shot, whole;
  InverseSolution solution;
  for (int i = 0; i < 2000; ++i) {
    const Pose X_BT = test::tipPose(model, test::randomJoints(model, random), tip);
    const std::vector<double> q_start = test::randomJoints(model, random);
    auto begin = Clock::now();
    (*inverse)->solveNearest(X_BT, q_start, kUnboundedDuration, solution);
    one_shot.push_back(microseconds(begin));
    begin = Clock::now();
    const InverseSolution nearest = (*inverse)->solve(X_BT, q_start);
    whole.push_back(microseconds(begin));
  }
  print(robot, "cold, one shot", one_shot);
  print(robot, "cold, nearest of all (restarts)", whole);
}

}  // namespace

int main() {
  const std::pair<const char*, RobotModel> robots[] = {
      {"KR 120", test::kr120()}, {"UR5e", test::ur5e()}, {"Panda", test::panda()}};
  for (const auto& [name, model] : robots) {
    track(name, "tracking at 1 kHz, inside", model, 0.0);
    track(name, "tracking at 1 kHz, 1 m beyond", model, 1.0);
    cold(name, model);
  }
  return 0;
}
