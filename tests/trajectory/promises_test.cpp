// SPDX-License-Identifier: Apache-2.0
// What is measured on written motions: against motions whose figures are known.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/promise.h"
#include "trajectory/checks/motion_measures.h"
#include "trajectory/retiming.h"
#include "trajectory/simplification.h"

namespace hapticell::trajectory {
namespace {

TEST(Promises, TheWorstIsNamedWithPlaceAndHelp) {
  Promises promises;
  promises.help = "Take a larger tolerance.";
  promises.list.push_back({"position", 0.001, 0.0009, "m"});
  EXPECT_TRUE(promises.areKept());
  promises.list.push_back({"angle", 0.01, 0.02, "rad", "at 1.5 s"});
  promises.list.push_back({"position", 0.001, 0.0137, "m", "at 2 s"});
  ASSERT_FALSE(promises.areKept());
  EXPECT_EQ(promises.worst()->place, "at 2 s");
  EXPECT_EQ(promises.missed("s.csv").message(),
            "s.csv, at 2 s: position 0.0137 m; expected at most 0.001 m. Take a larger tolerance. Nothing is written "
            "without --allow-miss.");
  promises.list = {{"clearance", 0.01, 0.02, "m", "", true}};
  EXPECT_TRUE(promises.areKept());
  promises.list[0].measured = std::nan("");
  EXPECT_FALSE(promises.areKept()) << "what could not be measured is not kept";
}

TEST(MotionMeasures, DerivativesAreThoseOfAKnownMotion) {
  for (const double odd : {0.0, 0.3}) {
    Trajectory wave;
    wave.joint_names = {"a"};
    for (int i = 0; i <= 3142; ++i) {  // To where the joint rests again.
      const double t = 0.002 * (i + (i % 2 == 1 ? odd : 0.0));
      const double q[] = {std::pow(std::sin(0.5 * t), 4)};
      wave.addFrame({t, Pose{{0, 0, std::sin(t)}, glm::angleAxis(1.5 * std::sin(t), dvec3(0, 0.6, 0.8))}}, q);
    }
    const auto joint = trajectory_checks::derivativesOf(wave, true, 1.0);
    // sin^4(t/2) = (3 - 4 cos t + cos 2t) / 8.
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    for (double t = 0.0; t < 6.2832; t += 1e-4) {
      speed = std::max(speed, std::abs(4 * std::sin(t) - 2 * std::sin(2 * t)) / 8);
      acceleration = std::max(acceleration, std::abs(4 * std::cos(t) - 4 * std::cos(2 * t)) / 8);
      jerk = std::max(jerk, std::abs(-4 * std::sin(t) + 8 * std::sin(2 * t)) / 8);
    }
    EXPECT_NEAR(joint.speed[0], speed, 1e-5 * speed);
    EXPECT_NEAR(joint.acceleration[0], acceleration, 1e-4 * acceleration);
    EXPECT_NEAR(joint.jerk[0], jerk, 1e-2 * jerk);
    const auto pose = trajectory_checks::derivativesOf(wave, false, 0.0);
    EXPECT_NEAR(pose.speed[2], 1.0, 1e-5);
    EXPECT_NEAR(pose.speed[4], 1.5 * 0.6, 1e-5);
    EXPECT_NEAR(pose.speed[5], 1.5 * 0.8, 1e-5);
  }
}

TEST(MotionMeasures, PassingFollowsAPathThatComesByAgain) {
  Trajectory rounds;
  for (int i = 0; i <= 630; ++i) {
    const double t = 0.05 * i;
    rounds.addFrame({t, Pose::translation({0.1 * std::cos(t), 0.1 * std::sin(t), 0.0})});
  }
  const Trajectory few = simplified(rounds, {});
  const auto off = trajectory_checks::passing(rounds, few, {});
  EXPECT_LE(off.position, 0.001 + 1e-9);
  EXPECT_GE(off.position, 0.0005);
  EXPECT_NEAR(off.position, largestDeviation(rounds, few).pose.position, 1e-5);
  // One round is missing: the frames of it are not passed in their order.
  Trajectory less;
  for (std::size_t i = 0; i < 500; ++i) less.addFrame(rounds[i]);
  EXPECT_GT(trajectory_checks::passing(rounds, less, {}).position, 0.05);
  // Displaced at one place: told with its time.
  Trajectory bent = rounds.emptyCopy();
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    auto frame = rounds[i];
    if (i >= 300 && i < 304) frame.X_WT.p.z += 0.004;
    bent.addFrame(frame);
  }
  const auto told = trajectory_checks::passing(rounds, bent, {});
  EXPECT_NEAR(told.position, 0.004, 1e-4);
  EXPECT_NEAR(told.t_position, 15.05, 0.2);
}

TEST(Simplification, KeepsWhatOnlyJointsMove) {
  Trajectory rail;
  rail.joint_names = {"rail", "arm"};
  for (int i = 0; i < 100; ++i) {
    const double q[] = {0.3 * std::sin(0.1 * i), -0.3 * std::cos(0.1 * i)};
    rail.addFrame({0.1 * i, Pose::translation({1, 0, 0})}, q);
  }
  const Trajectory few = simplified(rail, {});
  EXPECT_GT(few.size(), 20u);
  EXPECT_LE(trajectory_checks::passing(rail, few, {}).joint, 0.001 + 1e-9);
  PathTolerance poses_alone;
  poses_alone.joint = std::numeric_limits<double>::infinity();
  EXPECT_EQ(simplified(rail, poses_alone).size(), 2u);
}

}  // namespace
}  // namespace hapticell::trajectory
