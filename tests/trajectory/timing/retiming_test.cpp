// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/retiming.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/trajectory/motion/motions.h"
#include "trajectory/timing/straight_timing.h"

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
  EXPECT_LE(result->report.max_deviation.position, 5e-5);
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
    const double jitter = i % 2 == 0 ? 1e-13 : 0.0;
    const double x = i < 50 ? 0.0 : 0.002 * (i - 50) + jitter;
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

/// Largest derivatives of the frames, by differences written here; in shares of one limit for all.
struct Used {
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
};

Used usedBy(const Trajectory& motion, double velocity, double acceleration, double jerk) {
  Used used;
  std::vector<std::vector<double>> steps;
  std::vector<double> at;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const double dt = motion[i].t - motion[i - 1].t;
    std::vector<double> step;
    for (std::size_t j = 0; j < motion.joint_names.size(); ++j)
      step.push_back((motion.joints(i)[j] - motion.joints(i - 1)[j]) / dt);
    if (step.empty()) {
      const dvec3 p = (motion[i].X_WT.p - motion[i - 1].X_WT.p) / dt;
      const dvec3 w = rotationVector(motion[i].X_WT.q * glm::conjugate(motion[i - 1].X_WT.q)) / dt;
      step = {p.x, p.y, p.z, w.x, w.y, w.z};
    }
    steps.push_back(step);
    at.push_back(0.5 * (motion[i].t + motion[i - 1].t));
  }
  std::vector<std::vector<double>> bends;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const double v : steps[i]) used.velocity = std::max(used.velocity, std::abs(v) / velocity);
    if (i == 0) continue;
    std::vector<double> bend;
    for (std::size_t j = 0; j < steps[i].size(); ++j)
      bend.push_back((steps[i][j] - steps[i - 1][j]) / (at[i] - at[i - 1]));
    for (const double a : bend) used.acceleration = std::max(used.acceleration, std::abs(a) / acceleration);
    if (!bends.empty()) {
      for (std::size_t j = 0; j < bend.size(); ++j)
        used.jerk = std::max(used.jerk, std::abs(bend[j] - bends.back()[j]) / (at[i] - at[i - 1]) / jerk);
    }
    bends.push_back(bend);
  }
  return used;
}

/// How far a frame is from the nearest straight way between frames, by position alone.
double offWay(const dvec3& p, const Trajectory& motion) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const dvec3 a = motion[i].X_WT.p, way = motion[i + 1].X_WT.p - a;
    const double length = glm::dot(way, way);
    const double share = length > 0.0 ? glm::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(p - a - share * way));
  }
  return least;
}

Trajectory through(const std::vector<dvec3>& places) {
  Trajectory motion;
  for (std::size_t i = 0; i < places.size(); ++i)
    motion.addFrame({static_cast<double>(i), Pose::translation(places[i])});
  return motion;
}

RetimingOptions withLimits(std::size_t dimensions, double velocity, double acceleration, double jerk) {
  RetimingOptions options;
  options.limits.velocity.assign(dimensions, velocity);
  options.limits.acceleration.assign(dimensions, acceleration);
  if (jerk > 0.0) options.limits.jerk.assign(dimensions, jerk);
  return options;
}

// Few frames, sharp corners, gentle ones, a polygon round a circle, steps of 5 mm: each frame is passed within 0.05 mm
// and every limit is kept by the written frames.
TEST(Retiming, PassesEveryFrameHoweverFewAndSharp) {
  std::vector<std::vector<dvec3>> ways{
      {{0, 0, 0}, {0.2, 0, 0}, {0.2, 0.15, 0}, {0.2, 0.15, -0.1}, {0.2, 0.15, 0}, {0, 0, 0}},
      {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}, {0, 0, 0}}};
  for (const int corners : {3, 5, 8, 13, 24, 60}) {
    std::vector<dvec3> polygon;
    for (int i = 0; i <= corners; ++i) {
      const double a = 2.0 * std::numbers::pi * i / corners;
      polygon.push_back({0.3 * std::cos(a), 0.3 * std::sin(a), 0.01 * i});
    }
    ways.push_back(polygon);
  }
  std::vector<dvec3> steps;
  for (int i = 0; i <= 20; ++i) steps.push_back({0.005 * i, 0, 0});
  for (int i = 1; i <= 20; ++i) steps.push_back({0.1, 0.005 * i, 0});
  ways.push_back(steps);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  for (int k = 0; k < 4; ++k) {
    std::vector<dvec3> any;
    for (int i = 0; i < 6; ++i) any.push_back({place(random), place(random), place(random)});
    ways.push_back(any);
  }
  for (const double jerk : {0.0, 20.0}) {
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const Trajectory given = through(ways[k]);
      const auto result = retimed(given, withLimits(6, 0.5, 2.0, jerk));
      ASSERT_TRUE(result.has_value()) << k;
      for (const dvec3& p : ways[k]) EXPECT_LE(offWay(p, result->trajectory), 5.001e-5) << k;
      for (std::size_t i = 0; i < result->trajectory.size(); i += 7)
        EXPECT_LE(offWay(result->trajectory[i].X_WT.p, given), 1.1e-3) << k;
      const Used used = usedBy(result->trajectory, 0.5, 2.0, jerk);
      EXPECT_LE(used.velocity, 1.001) << k;
      EXPECT_LE(used.acceleration, 1.001) << k;
      if (jerk > 0.0) {
        EXPECT_LE(used.jerk, 1.001) << k;
      }
    }
  }
}

TEST(Retiming, TurnsOfAnySizeKeepTheirLimit) {
  for (const double degrees : {10.0, 60.0, 90.0, 120.0, 150.0, 179.0, 180.0}) {
    for (const int frames : {2, 3, 5}) {
      for (const dvec3& axis : {dvec3(0, 0, 1), glm::normalize(dvec3(1, -2, 0.5))}) {
        Trajectory turn;
        for (int i = 0; i < frames; ++i)
          turn.addFrame({1.0 * i, Pose::rotation(glm::angleAxis(degrees * i / 57.29577951308232, axis))});
        RetimingOptions options = withLimits(6, 2.0, 1000.0, 0.0);
        options.sample_s = 0.002;
        const auto result = retimed(turn, options);
        ASSERT_TRUE(result.has_value());
        const Used used = usedBy(result->trajectory, 2.0, 1000.0, 1.0);
        EXPECT_LE(used.velocity, 1.001) << degrees << ", " << frames;
        EXPECT_GE(used.velocity, 0.98) << degrees << ", " << frames;
        // One axis all the way: the angle at the greatest rate that a coordinate allows.
        const double most = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
        EXPECT_NEAR(result->report.duration_after, degrees * (frames - 1) / 57.29577951308232 * most / 2.0, 0.01);
      }
    }
  }
  // About an axis that turns itself.
  Trajectory tumble;
  dquat q(1, 0, 0, 0);
  for (int i = 0; i < 40; ++i) {
    tumble.addFrame({0.1 * i, Pose::rotation(q)});
    q = glm::normalize(quaternionFromRotationVector(0.25 * dvec3(std::cos(0.2 * i), std::sin(0.2 * i), 0.3)) * q);
  }
  const auto result = retimed(tumble, withLimits(6, 2.0, 20.0, 400.0));
  ASSERT_TRUE(result.has_value());
  const Used used = usedBy(result->trajectory, 2.0, 20.0, 400.0);
  EXPECT_LE(used.velocity, 1.001);
  EXPECT_LE(used.acceleration, 1.002);
  EXPECT_LE(used.jerk, 1.01);  // Turns do not add up quite as vectors: parts in a hundred at these steps.
}

TEST(Retiming, SmallJerkLimitsHold) {
  Trajectory wave;
  for (int i = 0; i < 20; ++i) wave.addFrame({0.1 * i, Pose::translation({0.01 * i, 0.002 * std::sin(0.5 * i), 0.0})});
  for (const double jerk : {1.0, 0.1, 0.01, 0.001}) {
    RetimingOptions options = withLimits(6, 0.5, 2.0, jerk);
    options.sample_s = 0.01;
    const auto result = retimed(wave, options);
    ASSERT_TRUE(result.has_value());
    EXPECT_LE(usedBy(result->trajectory, 0.5, 2.0, jerk).jerk, 1.001) << jerk;
    EXPECT_GE(result->report.use.jerk, 0.9) << jerk;
  }
}

TEST(Retiming, ConstantSpeedIsNotPassedInCorners) {
  const Trajectory square = through({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}, {0, 0, 0}});
  RetimingOptions options;
  options.mode = TimingMode::kConstantSpeed;
  options.speed = 0.05;
  const auto result = retimed(square, options);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->report.corners, 3u);
  EXPECT_LE(usedBy(result->trajectory, 0.05, 1.0, 1.0).velocity, 1.001);
  // Four sides of 2 s, and 50 ms each of gaining and losing speed.
  EXPECT_NEAR(result->report.duration_after, 8.2, 0.05);
}

TEST(Retiming, JointsThatStandAreNotTimedByTheirLimits) {
  Trajectory carried;
  carried.joint_names = {"a"};
  const double stands[] = {0.5};
  for (int i = 0; i < 5; ++i) carried.addFrame({1.0 * i, Pose::translation({0.1 * i, 0, 0})}, stands);
  const auto result = retimed(carried, withLimits(1, 1.0, 1.0, 0.0));
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(result.error().message().find("joints do not"), std::string::npos) << result.error().message();
}

TEST(Retiming, RefusesMoreFramesThanAnybodyHasRoomFor) {
  Trajectory far;
  for (int i = 0; i < 12; ++i) far.addFrame({0.1 * i, Pose::translation({1e12 * i, 0.0, 0.0})});
  RetimingOptions options;
  options.mode = TimingMode::kConstantSpeed;
  const auto slow = retimed(far, options);
  ASSERT_FALSE(slow.has_value());
  EXPECT_NE(slow.error().message().find("10 million frames"), std::string::npos) << slow.error().message();
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
