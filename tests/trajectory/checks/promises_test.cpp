// SPDX-License-Identifier: Apache-2.0
// What is measured on written motions: against motions whose figures are known.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "geometry/system/promise.h"
#include "trajectory/checks/motion_measures.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::trajectory {
namespace {

TEST(Promises, TheWorstIsNamedWithPlaceAndHelp) {
  Promises promises;
  promises.help = "Use a larger tolerance.";
  promises.list.push_back({"position", 0.001, 0.0009, "m"});
  EXPECT_TRUE(promises.areKept());
  promises.list.push_back({"angle", 0.01, 0.02, "rad", "at 1.5 s"});
  promises.list.push_back({"position", 0.001, 0.0137, "m", "at 2 s"});
  ASSERT_FALSE(promises.areKept());
  EXPECT_EQ(english(promises.worst()->place), "at 2 s");
  EXPECT_EQ(promises.missed("s.csv").message(),
            "s.csv, at 2 s: position 0.0137 m; expected at most 0.001 m. Use a larger tolerance. Nothing was written. "
            "To write the file anyway, use --allow-miss.");
  promises.list = {{"clearance", 0.01, 0.02, "m", "", true}};
  EXPECT_TRUE(promises.areKept());
  promises.list[0].measured = std::nan("");
  EXPECT_FALSE(promises.areKept()) << "what could not be measured is not kept";
}

/// Poses in a file may be as asked while the joints bring the tool elsewhere: 4.86 mm to the side here.
TEST(Promises, SmoothingIsMeasuredWhereTheJointsBringTheTool) {
  Trajectory motion;
  motion.joint_names = {"q1"};
  for (int i = 0; i <= 20; ++i) {
    const std::vector<double> joints{0.01 * i};
    ASSERT_TRUE(motion.addFrame({0.1 * i, Pose::translation({0.02 * i, 0, 0})}, joints));
  }
  const auto file = std::filesystem::temp_directory_path() / ("placed-" + std::to_string(::getpid()) + ".htraj");
  std::ofstream(file) << toJsonText(motion);
  const PathTolerance tolerance{0.001, 0.02, 0.001};
  const auto placedOff = [](double off) {
    return [off](const Trajectory& read) -> Expected<Trajectory> {
      Trajectory placed = read.emptyCopy();
      for (std::size_t i = 0; i < read.size(); ++i) {
        Trajectory::Frame frame = read[i];
        if (i == 13) frame.X_WT.p.y += off;
        placed.addFrame(frame, read.joints(i));
      }
      return placed;
    };
  };
  const auto kept = trajectory_checks::smoothPromises(motion, tolerance, file, placedOff(0.0009));
  const auto missed = trajectory_checks::smoothPromises(motion, tolerance, file, placedOff(0.00486));
  std::filesystem::remove(file);
  ASSERT_TRUE(kept && missed);
  EXPECT_TRUE(kept->areKept());
  ASSERT_FALSE(missed->areKept());
  EXPECT_EQ(missed->worst()->name, "tool_position");
  EXPECT_NEAR(missed->worst()->measured, 0.00486, 1e-12);
  EXPECT_EQ(english(missed->worst()->place), "at 1.3 s");
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
