// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/segment_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hapticell::trajectory {
namespace {

class SegmentDistances : public ::testing::Test {
 protected:
  SegmentDistances() {
    for (Trajectory* each : {&frames_, &segments_}) each->joint_names = {"a", "b"};
  }
  void add(Trajectory& to, const Pose& X, double a, double b) {
    const double joints[] = {a, b};
    ASSERT_TRUE(to.addFrame({.t = static_cast<double>(to.size()), .X_WT = X}, joints));
  }
  Pose pose(double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const dvec3 p(uniform(random_), uniform(random_), uniform(random_));
    return {p, quaternionFromRotationVector(dvec3(uniform(random_), uniform(random_), uniform(random_)))};
  }
  std::mt19937_64 random_{3};
  Trajectory frames_, segments_;
  PathTolerance tolerance_{.position = 0.01, .angle = 0.05, .joint = 0.02};
};

TEST_F(SegmentDistances, AFrameOnTheSegmentIsNotOff) {
  const Pose X_0 = pose(0.5), X_1 = pose(0.5);
  add(segments_, X_0, 0.0, 1.0);
  add(segments_, X_1, 1.0, -1.0);
  for (const double share : {0.0, 0.3, 1.0}) add(frames_, interpolate(X_0, X_1, share), share, 1.0 - 2.0 * share);
  const SegmentDistance distance(frames_, segments_, tolerance_);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(distance.of(i, {0, 1}).shareOf(tolerance_), 1e-6);
    EXPECT_GE(distance.of(i, {0, 0}).shareOf(tolerance_) + (i == 0 ? 1.0 : 0.0), 1.0)
        << "a segment of one frame is a point";
  }
}

TEST_F(SegmentDistances, NoPlaceOfTheSegmentIsMuchNearer) {
  for (int trial = 0; trial < 50; ++trial) {
    frames_ = frames_.emptyCopy();
    segments_ = segments_.emptyCopy();
    const Pose X_0 = pose(0.1), X_1 = displaced(X_0, {{0.2, 0.1, 0.0}, {0.0, 0.1, 0.2}});
    add(segments_, X_0, 0.0, 0.0);
    add(segments_, X_1, 0.3, 0.1);
    add(frames_, displaced(interpolate(X_0, X_1, 0.4), {{0.01, -0.02, 0.005}, {0.02, 0.0, -0.01}}), 0.15, 0.02);
    const Deviation found = SegmentDistance(frames_, segments_, tolerance_).of(0, {0, 1});
    const auto squared = [&](double position, double angle, double a, double b) {
      return std::pow(position / tolerance_.position, 2) + std::pow(angle / tolerance_.angle, 2) +
             (a * a + b * b) / (tolerance_.joint * tolerance_.joint);
    };
    double least = 1e300, least_share = 1e300;
    for (int k = 0; k <= 1000; ++k) {
      const double share = k / 1000.0;
      const PoseDistance off = distanceBetween(frames_[0].X_WT, interpolate(X_0, X_1, share));
      const double value = squared(off.position, off.angle, 0.15 - 0.3 * share, 0.02 - 0.1 * share);
      least = std::min(least, value);
      const double joint = std::max(std::abs(0.15 - 0.3 * share), std::abs(0.02 - 0.1 * share));
      least_share = std::min(least_share, Deviation{off, joint}.shareOf(tolerance_));
    }
    EXPECT_GE(found.shareOf(tolerance_), least_share - 1e-3);
    EXPECT_LE(found.shareOf(tolerance_), std::sqrt(least) * 1.01) << "near the least of all squares";
  }
}

TEST_F(SegmentDistances, JointsWithoutATolerancePosesThatAreNotKnownDoNotCount) {
  add(segments_, {}, 0.0, 0.0);
  add(segments_, Pose::translation({1, 0, 0}), 1.0, 0.0);
  add(frames_, Pose::translation({0.5, 0.002, 0}), 9.0, 9.0);
  PathTolerance poses_only = tolerance_;
  poses_only.joint = std::numeric_limits<double>::infinity();
  const Deviation of_pose = SegmentDistance(frames_, segments_, poses_only).of(0, {0, 1});
  EXPECT_NEAR(of_pose.pose.position, 0.002, 1e-12);
  EXPECT_EQ(of_pose.joint, 0.0);
  // Frames of joints only: the poses of the segments say nothing of where on it they are.
  Trajectory joints_only;
  joints_only.joint_names = {"a", "b"};
  joints_only.has_poses = false;
  add(joints_only, {}, 0.75, 0.001);
  const Deviation of_joints = SegmentDistance(joints_only, segments_, tolerance_).of(0, {0, 1});
  EXPECT_EQ(of_joints.pose.position, 0.0);
  EXPECT_NEAR(of_joints.joint, 0.001, 1e-9);
}

TEST_F(SegmentDistances, DeviationsGrowByThemselves) {
  Deviation worst{{0.1, 0.5}, 0.0};
  worst.grow({{0.3, 0.2}, 0.01});
  EXPECT_EQ(worst.pose.position, 0.3);
  EXPECT_EQ(worst.pose.angle, 0.5);
  EXPECT_EQ(worst.joint, 0.01);
  EXPECT_NEAR(worst.shareOf(tolerance_), 30.0, 1e-12);
}

}  // namespace
}  // namespace hapticell::trajectory
