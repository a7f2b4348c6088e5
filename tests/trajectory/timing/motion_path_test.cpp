// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/motion_path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "trajectory/timing/frame_use.h"

namespace hapticell::trajectory {
namespace {

constexpr double kHalfTurnOfPath = std::numbers::pi;

Trajectory framesAt(const std::vector<Pose>& poses) {
  Trajectory frames;
  for (const Pose& X : poses) EXPECT_TRUE(frames.addFrame({.t = static_cast<double>(frames.size()), .X_WT = X}));
  return frames;
}

std::vector<double> waysOf(const Trajectory& frames) {
  std::vector<double> ways{0.0};
  for (std::size_t i = 1; i < frames.size(); ++i) {
    ways.push_back(ways.back() + 1e-3 + glm::distance(frames[i].X_WT.p, frames[i - 1].X_WT.p));
  }
  return ways;
}

TEST(MotionPath, AStraightOneGoesInProportion) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 10; ++i) {
    poses.push_back({dvec3(0.1 * i, 0.02 * i, 0.0), glm::angleAxis(0.1 * i, glm::normalize(dvec3(1, 1, 0)))});
  }
  const Trajectory frames = framesAt(poses);
  const StraightPath path(frames, 2.0, LimitedBy::kPose);
  EXPECT_TRUE(path.isStraight());
  EXPECT_EQ(path.dimensions(), 6u);
  EXPECT_EQ(path.breaks().front(), 0.0);
  EXPECT_EQ(path.breaks().back(), 2.0);
  for (std::size_t i = 0; i <= 10; ++i) {
    const PoseDistance off = distanceBetween(path.pose(0.2 * static_cast<double>(i)), poses[i]);
    EXPECT_LT(off.position + off.angle, 1e-9);
  }
  std::array<double, 6> first{}, second{};
  path.derivatives(0.7, first, second);
  EXPECT_NEAR(first[0], 0.5, 1e-12) << "1 m over 2 of the parameter";
  EXPECT_NEAR(std::hypot(first[3], first[4]), 0.5, 1e-12) << "1 rad over 2";
  for (const double value : second) EXPECT_NEAR(value, 0.0, 1e-12);
}

TEST(MotionPath, MoreThanHalfATurnIsGoneAsTheFramesGo) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 12; ++i) poses.push_back(Pose::rotation(glm::angleAxis(0.5 * i, dvec3(0, 0, 1))));
  const Trajectory frames = framesAt(poses);
  const std::vector<dvec3> turns = runningTurns(frames);
  for (std::size_t i = 0; i < turns.size(); ++i) EXPECT_NEAR(turns[i].z, 0.5 * static_cast<double>(i), 1e-9);
  EXPECT_GT(turns.back().z, kHalfTurnOfPath) << "and does not leap at half a turn";
  const StraightPath path(frames, 6.0, LimitedBy::kPose);
  for (int i = 0; i <= 12; ++i) {
    EXPECT_LT(distanceBetween(path.pose(0.5 * i), poses[static_cast<std::size_t>(i)]).angle, 1e-6);
  }
}

TEST(MotionPath, ThroughFramesKeepsToTheToleranceWhateverTheyAre) {
  std::vector<Pose> line, arc, corner;
  for (int i = 0; i <= 40; ++i) {
    const double u = 0.01 * i;
    line.push_back(Pose::translation({u, 2.0 * u, 0.0}));
    arc.push_back(
        {dvec3(0.3 * std::cos(5.0 * u), 0.3 * std::sin(5.0 * u), 0.0), glm::angleAxis(5.0 * u, dvec3(0, 0, 1))});
    corner.push_back(Pose::translation(i <= 20 ? dvec3(u, 0.0, 0.0) : dvec3(0.2, u - 0.2, 0.0)));
  }
  const PathTolerance tolerance{.position = 5e-4, .angle = 5e-3};
  for (const auto& poses : {line, arc, corner}) {
    const Trajectory frames = framesAt(poses);
    const std::vector<double> ways = waysOf(frames);
    const auto path = pathThrough(frames, ways, tolerance, LimitedBy::kPose);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->isStraight(), poses[1].p.y > 0.015) << "the line only";
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_LE(tolerance.shareOf(distanceBetween(path->pose(ways[i]), frames[i].X_WT)), 1.0 + 1e-6) << i;
    }
    // The derivatives are those of the poses.
    const double u = 0.41 * ways.back(), h = 1e-5;
    std::array<double, 6> first{}, second{};
    path->derivatives(u, first, second);
    const dvec3 slope = (path->pose(u + h).p - path->pose(u - h).p) / (2.0 * h);
    EXPECT_LT(glm::distance(slope, dvec3(first[0], first[1], first[2])), 1e-5);
  }
}

TEST(MotionPath, OnlySharpTurnsAreCorners) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 40; ++i) {
    const double u = 0.01 * i;
    poses.push_back(Pose::translation(i <= 20 ? dvec3(u, 0.0, 0.0) : dvec3(0.2, u - 0.2, 0.0)));
  }
  const PathTolerance tolerance{.position = 1e-4, .angle = 5e-3};
  EXPECT_EQ(cornersOf(framesAt(poses), tolerance, LimitedBy::kPose, 0.5), (std::vector<std::size_t>{20}));
  EXPECT_TRUE(cornersOf(framesAt(poses), tolerance, LimitedBy::kPose, 1.7).empty()) << "a right angle is less";
  poses.erase(poses.begin() + 21, poses.end());
  EXPECT_TRUE(cornersOf(framesAt(poses), tolerance, LimitedBy::kPose, 0.5).empty());
}

TEST(FrameUse, ConstantSpeedAndItsBeginAreFoundByDifferences) {
  Trajectory frames;
  frames.joint_names = {"a"};
  for (int i = 0; i <= 50; ++i) {
    const double joint[] = {0.01 * i};
    ASSERT_TRUE(frames.addFrame({.t = 0.01 * i, .X_WT = {}}, joint));
  }
  const MotionLimits limits{.velocity = {2.0}, .acceleration = {400.0}, .jerk = {}};
  const LimitUse use = useOfFrames(frames, 0.01, limits, LimitedBy::kJoints);
  EXPECT_NEAR(use.velocity, 0.5, 1e-9) << "1 rad/s of 2";
  EXPECT_NEAR(use.acceleration, 0.25, 1e-9) << "from rest to 1 rad/s in 10 ms: 100 of 400";
}

TEST(FrameUse, OfAPoseTheTurningCountsAsWell) {
  Trajectory frames;
  for (int i = 0; i <= 50; ++i) {
    ASSERT_TRUE(frames.addFrame({.t = 0.01 * i, .X_WT = Pose::rotation(glm::angleAxis(0.02 * i, dvec3(0, 1, 0)))}));
  }
  const MotionLimits limits{
      .velocity = std::vector<double>(6, 4.0), .acceleration = std::vector<double>(6, 1e4), .jerk = {}};
  EXPECT_NEAR(useOfFrames(frames, 0.01, limits, LimitedBy::kPose).velocity, 0.5, 1e-6);
}

}  // namespace
}  // namespace hapticell::trajectory
