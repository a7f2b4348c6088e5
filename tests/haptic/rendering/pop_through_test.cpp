// SPDX-License-Identifier: Apache-2.0
// M8 of docs/feel.md: a thin plate is never passed through, however the stylus is dragged and however slow the client
// is.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/haptic/rendering/feel_session.h"

namespace hapticell::haptic::test {
namespace {

constexpr double kTick = 0.001;
constexpr double kHalfWidth = 0.05, kHalfThickness = 0.0005;

struct Sweep {
  dvec3 from{0.0}, to{0.0};
  double speed = 0.1;
  double tremor_hz = 10.0, tremor = 0.0;
};

/// From one side to the other, straight, beside and over the rim too; 0.05 to 1 m/s with tremor of 10 to 30 Hz.
Sweep randomSweep(std::mt19937_64& random) {
  std::uniform_real_distribution<double> side(-0.06, 0.06), height(0.004, 0.02), unit(0.0, 1.0);
  Sweep sweep;
  const double sign = unit(random) < 0.5 ? -1.0 : 1.0;
  sweep.from = {side(random), side(random), sign * height(random)};
  sweep.to = {side(random), side(random), -sign * height(random)};
  sweep.speed = 0.05 * std::pow(20.0, unit(random));
  sweep.tremor_hz = 10.0 + 20.0 * unit(random);
  sweep.tremor = 0.5e-3 * unit(random);
  return sweep;
}

bool crosses(const dvec3& a, const dvec3& b) {
  // A chord of one tick that enters by one face and leaves by the other, away from the rim that it may round.
  if (!(std::abs(a.z) >= 0.9 * kHalfThickness && std::abs(b.z) >= 0.9 * kHalfThickness && a.z * b.z < 0.0))
    return false;
  const dvec3 at = glm::mix(a, b, a.z / (a.z - b.z));
  const double margin = 0.004;
  return std::max(std::abs(at.x), std::abs(at.y)) < kHalfWidth - margin;
}

struct Outcome {
  int pops = 0;
  double penetration = 0.0;
};

void run(const Sweep& sweep, const FeelScene& plate, ClientRate rate, Outcome& outcome) {
  ForceRenderer renderer;
  SlowClient client(plate, rate);
  renderer.reset(Pose::translation(sweep.from));
  const dvec3 way = sweep.to - sweep.from;
  const double duration = glm::length(way) / sweep.speed;
  double t = 0.0;
  // The client has time to speak first, as behind the engage gate.
  for (; t < rate.latency + 0.005; t += kTick) {
    client.step(t, renderer);
    renderer.tick(Pose::translation(sweep.from), kTick);
  }
  const double start = t;
  dvec3 before = renderer.proxy().p;
  for (; t < start + duration; t += kTick) {
    const double s = t - start;
    const double shake = sweep.tremor * std::sin(2.0 * M_PI * sweep.tremor_hz * s);
    const dvec3 p = glm::round((sweep.from + way * (s / duration) + dvec3(0, 0, shake)) / 2e-5) * 2e-5;
    client.step(t, renderer);
    renderer.tick(Pose::translation(p), kTick);
    const dvec3 now = renderer.proxy().p;
    outcome.penetration = std::max(outcome.penetration, plate.penetration(renderer.proxy()));
    outcome.pops += crosses(before, now) ? 1 : 0;
    before = now;
  }
}

class PopThrough : public ::testing::TestWithParam<int> {};

TEST_P(PopThrough, neverHappensInFiveThousandSweeps) {
  const ClientRate rate = kRates[GetParam()];
  const auto plate = plateScene();
  std::mt19937_64 random(2026 + static_cast<std::uint64_t>(GetParam()));
  Outcome outcome;
  for (int i = 0; i < 5000; ++i) run(randomSweep(random), *plate, rate, outcome);
  std::printf("%4.0f Hz: %d pops, deepest proxy %.4f mm\n", rate.rate_hz, outcome.pops, outcome.penetration * 1e3);
  EXPECT_EQ(outcome.pops, 0);
  EXPECT_LE(outcome.penetration, 0.05e-3);
}

INSTANTIATE_TEST_SUITE_P(Rates, PopThrough, ::testing::Values(0, 1, 2));

TEST(PopThroughCheck, findsARealPop) {
  // The check itself: a proxy that is simply put on the stylus crosses the plate.
  EXPECT_TRUE(crosses({0, 0, 0.001}, {0, 0, -0.001}));
  EXPECT_FALSE(crosses({0.049, 0, 0.001}, {0.051, 0, -0.001}));
  EXPECT_FALSE(crosses({0, 0, 0.002}, {0, 0, 0.001}));
}

}  // namespace
}  // namespace hapticell::haptic::test
