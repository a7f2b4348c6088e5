// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/cycle_route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hapticell::studies {
namespace {

using manipulation::FreeAnswer;

const JointRates kRates{{1.0, 2.0, 0.5}, {4.0, 4.0, 4.0}};

std::vector<FreeAnswer> someTargets(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-2.0, 2.0);
  std::vector<FreeAnswer> targets(count);
  for (FreeAnswer& target : targets) {
    for (int i = 0; i < 3; ++i)
      target.free.push_back({{angle(random), angle(random), angle(random)}, std::string(1, static_cast<char>('a' + i))});
  }
  return targets;
}

/// The least time of all choices, tried one by one.
double triedAll(const std::vector<double>& start, const std::vector<FreeAnswer>& targets, std::size_t k,
                const std::vector<double>& at) {
  if (k == targets.size()) return straightTime(kRates, at, start);
  double least = 1e9;
  for (const auto& solution : targets[k].free)
    least = std::min(least, straightTime(kRates, at, solution.joints) + triedAll(start, targets, k + 1, solution.joints));
  return least;
}

TEST(CycleRoute, AStraightMotionTakesTheTimeOfItsSlowestJoint) {
  // 1 rad at 1 rad/s with 4 rad/s2: a trapezoid of 1 s + 0.25 s.
  EXPECT_NEAR(straightTime(kRates, {0, 0, 0}, {1, 0, 0}), 1.25, 1e-12);
  // 0.04 rad never reaches the speed: 2 sqrt(0.04 / 4).
  EXPECT_NEAR(straightTime(kRates, {0, 0, 0}, {0.04, 0, 0}), 0.2, 1e-12);
  EXPECT_EQ(straightTime(kRates, {1, 2, 3}, {1, 2, 3}), 0.0);
}

TEST(CycleRoute, IsTheBestOfAllChoices) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const auto targets = someTargets(5, seed);
    const std::vector<double> start(3, 0.0);
    const CycleRoute route = fastestRoute(kRates, start, targets, true);
    EXPECT_NEAR(route.time_s, triedAll(start, targets, 0, start), 1e-9);
    double sum = 0.0;
    std::vector<double> at = start;
    for (const auto* stop : route.stops) {
      sum += straightTime(kRates, at, stop->joints);
      at = stop->joints;
    }
    EXPECT_NEAR(sum + straightTime(kRates, at, start), route.time_s, 1e-9);
  }
}

TEST(CycleRoute, HasNoRouteWhereATargetIsMissed) {
  auto targets = someTargets(3, 1);
  targets[1].free.clear();
  EXPECT_TRUE(fastestRoute(kRates, {0, 0, 0}, targets, false).stops.empty());
}

}  // namespace
}  // namespace hapticell::studies
