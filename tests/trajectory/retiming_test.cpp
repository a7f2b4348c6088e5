// SPDX-License-Identifier: Apache-2.0
#include "trajectory/retiming.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/trajectory/motions.h"

namespace hapticell::trajectory {
namespace {

/// A smooth path in joint space through random points.
CubicSpline randomPath(std::mt19937& random, std::size_t dimensions, std::size_t points) {
  std::uniform_real_distribution<double> joint(-1.5, 1.5);
  std::vector<double> u, values, breaks;
  for (std::size_t i = 0; i < points; ++i) {
    u.push_back(static_cast<double>(i));
    for (std::size_t j = 0; j < dimensions; ++j) values.push_back(joint(random));
  }
  breaks = u;
  return fitSpline({u, values, {}, dimensions}, breaks, 1e-9);
}

MotionLimits robotLimits(std::size_t dimensions) {
  MotionLimits limits;
  for (std::size_t j = 0; j < dimensions; ++j) {
    limits.velocity.push_back(2.0 + 0.3 * static_cast<double>(j));
    limits.acceleration.push_back(6.0 + static_cast<double>(j));
  }
  return limits;
}

TEST(TimeOptimal, StraightPathTakesTheTrapezoidsTime) {
  const std::vector<double> u{0.0, 1.0}, values{0.0, 3.0};
  const CubicSpline line = fitSpline({u, values, {}, 1}, {0.0, 1.0}, 1e-12);
  // 3 rad at 2 rad/s and 8 rad/s2: 2/8 s up, 2/8 s down, the rest at full speed.
  const auto timing = timeOptimal(line, {{2.0}, {8.0}, {}});
  ASSERT_TRUE(timing.has_value());
  EXPECT_NEAR(timing->duration(), 3.0 / 2.0 + 2.0 / 8.0, 2e-3);
  // Without reaching full speed: 2 sqrt(way / a).
  EXPECT_NEAR(timeOptimal(line, {{100.0}, {8.0}, {}})->duration(), 2.0 * std::sqrt(3.0 / 8.0), 2e-3);
}

TEST(TimeOptimal, RandomPathsAreAllSolvedWithinTheLimitsAndNearTheOptimum) {
  std::mt19937 random(3);
  const MotionLimits limits = robotLimits(6);
  for (int i = 0; i < 40; ++i) {
    const CubicSpline path = randomPath(random, 6, 5 + static_cast<std::size_t>(i % 20));
    const auto timing = timeOptimal(path, limits);
    ASSERT_TRUE(timing.has_value()) << i << ": " << timing.error().message();
    const LimitUse use = limitUse(path, *timing, limits, 3e-4);
    EXPECT_LE(use.velocity, 1.001) << i;
    EXPECT_LE(use.acceleration, 1.001) << i;
    const auto fine = timeOptimal(path, limits, {4000});
    EXPECT_NEAR(timing->duration(), fine->duration(), 0.01 * fine->duration()) << i;
    // The limits are used: something is at its bound most of the time.
    EXPECT_GE(std::max(use.velocity, use.acceleration), 0.99) << i;
  }
}

TEST(TimeOptimal, JerkLimitHoldsAndCostsTime) {
  std::mt19937 random(5);
  for (int i = 0; i < 5; ++i) {
    const CubicSpline path = randomPath(random, 6, 8);
    MotionLimits limits = robotLimits(6);
    const double free = timeOptimal(path, limits)->duration();
    limits.jerk.assign(6, 80.0);
    const auto timing = jerkLimited(path, limits);
    ASSERT_TRUE(timing.has_value());
    const LimitUse use = limitUse(path, *timing, limits, 1e-3);
    EXPECT_LE(use.velocity, 1.001);
    EXPECT_LE(use.acceleration, 1.001);
    EXPECT_LE(use.jerk, 1.001);
    EXPECT_GE(timing->duration(), free);
    EXPECT_LE(timing->duration(), 1.5 * free);
  }
}

TEST(TimeOptimal, RefusesLimitsThatAreNone) {
  const std::vector<double> u{0.0, 1.0}, values{0.0, 3.0};
  const CubicSpline line = fitSpline({u, values, {}, 1}, {0.0, 1.0});
  EXPECT_FALSE(timeOptimal(line, {{0.0}, {8.0}, {}}).has_value());
  EXPECT_FALSE(timeOptimal(line, {{1.0, 2.0}, {8.0}, {}}).has_value());
  EXPECT_FALSE(timeOptimal(line, {{1.0}, {1.0}, {}}, {1000, 50.0, 0.0}).has_value());
}

Trajectory robotGesture() {
  Trajectory trajectory;
  trajectory.joint_names = {"a", "b", "c"};
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.01 * i;
    const double joints[] = {std::sin(t), 0.7 * std::sin(1.3 * t), 0.2 * t};
    trajectory.addFrame({t, test::gestureAt(t)}, joints);
  }
  return trajectory;
}

TEST(Retiming, TimeOptimalKeepsThePathAndTheLimits) {
  RetimingOptions options;
  options.limits = {{2.0, 2.0, 2.0}, {10.0, 10.0, 10.0}, {}};
  options.sample_s = 0.002;
  const auto result = retimed(robotGesture(), options);
  ASSERT_TRUE(result.has_value()) << result.error().message();
  EXPECT_LT(result->report.duration_after, result->report.duration_before);
  EXPECT_LE(result->report.max_deviation.position, 1e-4);
  EXPECT_LE(result->report.max_joint_deviation, 2e-4);
  const Trajectory& fast = result->trajectory;
  for (std::size_t i = 1; i + 1 < fast.size(); ++i) {
    ASSERT_GT(fast[i].t, fast[i - 1].t);
    for (std::size_t j = 0; j < 3; ++j) {
      const double dt = fast[i + 1].t - fast[i].t;
      EXPECT_LE(std::abs(fast.joints(i + 1)[j] - fast.joints(i)[j]) / dt, 2.0 * 1.005);
    }
  }
  EXPECT_NEAR(fast.joints(fast.size() - 1)[2], 0.8, 1e-4);
}

TEST(Retiming, ConstantSpeedIsConstantBetweenTheRamps) {
  RetimingOptions options;
  options.mode = TimingMode::kConstantSpeed;
  options.speed = 0.05;
  options.metres_per_radian = 1e-9;
  const auto result = retimed(robotGesture(), options);
  ASSERT_TRUE(result.has_value());
  const Trajectory& slow = result->trajectory;
  for (std::size_t i = slow.size() / 5; i < slow.size() * 4 / 5; i += 7) {
    const double dt = slow[i + 1].t - slow[i].t;
    EXPECT_NEAR(glm::length(slow[i + 1].X_WT.p - slow[i].X_WT.p) / dt, 0.05, 0.0015);
  }
}

TEST(Retiming, RestsAtDwellsAndPassesStillFramesOver) {
  Trajectory trajectory;
  for (int i = 0; i <= 300; ++i) {
    // Still at the start, a dwell in the middle, nearly repeated frames after it.
    const double x = i < 50 ? 0.0 : 0.002 * (i - 50) + (i % 2 == 0 ? 1e-13 : 0.0);
    trajectory.addFrame({0.01 * i, Pose::translation({x, 0, 0}), false, i == 175 ? 1.5 : 0.0});
  }
  RetimingOptions options;
  options.limits = {std::vector<double>(6, 0.5), std::vector<double>(6, 2.0), {}};
  const auto result = retimed(trajectory, options);
  ASSERT_TRUE(result.has_value());
  EXPECT_GE(result->report.still_frames, 49u);
  bool has_dwell = false;
  for (const auto& frame : result->trajectory.frames()) {
    if (frame.dwell != 1.5) continue;
    has_dwell = true;
    EXPECT_NEAR(frame.X_WT.p.x, 0.25, 1e-4);
    EXPECT_NEAR(glm::length(result->trajectory.poseAt(frame.t + 1.4).p - frame.X_WT.p), 0.0, 1e-4);
  }
  EXPECT_TRUE(has_dwell);
  // Both halves of 0.25 m: trapezoids of 0.25/0.5 + 0.5/2 s.
  EXPECT_NEAR(result->report.duration_after, 2 * 0.75 + 1.5, 0.02);
}

TEST(Retiming, RefusesMoreFramesThanAnybodyHasRoomFor) {
  Trajectory far;
  for (int i = 0; i < 12; ++i) far.addFrame({0.1 * i, Pose::translation({1e12 * i, 0.0, 0.0})});
  RetimingOptions options;
  options.mode = TimingMode::kConstantSpeed;
  const auto slow = retimed(far, options);
  ASSERT_FALSE(slow.has_value());
  EXPECT_NE(slow.error().message().find("ten million frames"), std::string::npos) << slow.error().message();
  Trajectory near;
  for (int i = 0; i < 12; ++i) near.addFrame({0.1 * i, Pose::translation({0.01 * i, 0.0, 0.0})});
  options.sample_s = 0.0;
  EXPECT_FALSE(retimed(near, options).has_value());
}

TEST(Retiming, RefusesAMotionThatIsNone) {
  Trajectory still;
  for (int i = 0; i < 5; ++i) still.addFrame({0.1 * i, test::gestureAt(1.0)});
  EXPECT_FALSE(retimed(still, {}).has_value());
  EXPECT_FALSE(retimed(Trajectory{}, {}).has_value());
}

}  // namespace
}  // namespace hapticell::trajectory
