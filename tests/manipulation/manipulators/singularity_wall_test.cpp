// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/singularity_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

constexpr double kLever = 0.25;

struct Arm {
  kinematics::RobotModel model = kinematics::test::kr120();
  SingularityWall wall{model, model.defaultTip(), {}, kLever};
  std::vector<double> at(double j5) const { return {0.2, -1.3, 1.4, 0.1, j5, 0.3}; }
};

// Two slides at an angle: the singular values of two unit columns are sqrt(1 +- cos).
TEST(SingularityWall, MeasuresTheLeastSingularValue) {
  for (const double angle : {0.1, 0.7, 1.5}) {
    kinematics::RobotModel model = kinematics::test::emptyModel();
    kinematics::test::addJoint(model, 0, "x", kinematics::JointType::kPrismatic, {1, 0, 0}, {});
    kinematics::test::addJoint(model, 1, "y", kinematics::JointType::kPrismatic, {std::cos(angle), std::sin(angle), 0},
                               {});
    const SingularityWall wall(model, 2, {}, kLever);
    EXPECT_NEAR(wall.measure({0.3, -0.2}), std::sqrt(1.0 - std::cos(angle)) / kLever, 1e-9) << angle;
  }
  // One axis: the length of its only column, with the tool at the end of a rod of 0.4 m.
  kinematics::RobotModel model = kinematics::test::emptyModel();
  kinematics::test::addJoint(model, 0, "turn", kinematics::JointType::kRevolute, {0, 0, 1}, {});
  const SingularityWall wall(model, 1, Pose::translation({0.4, 0, 0.7}), kLever);
  EXPECT_NEAR(wall.measure({1.0}), std::hypot(0.4 / kLever, 1.0), 1e-9);
}

TEST(SingularityWall, OfAWristIsAboutItsAngle) {
  const Arm arm;
  EXPECT_LT(arm.wall.measure(arm.at(0.0)), 1e-9);
  const double near = arm.wall.measure(arm.at(0.02));
  EXPECT_GT(near, 0.5 * 0.02);
  EXPECT_LT(near, 2.0 * 0.02);
  EXPECT_NEAR(arm.wall.measure(arm.at(0.04)) / near, 2.0, 0.02);
  EXPECT_NEAR(arm.wall.measure(arm.at(-0.02)), near, 0.02 * near) << "the same on both sides";
}

TEST(SingularityWall, ItsGradientIsThatOfItsMeasure) {
  const Arm arm;
  const std::vector<double> q = arm.at(0.3), gradient = arm.wall.gradient(q);
  ASSERT_EQ(gradient.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    // By five points, wide apart.
    const auto at = [&](double step) {
      std::vector<double> moved = q;
      moved[i] += step;
      return arm.wall.measure(moved);
    };
    const double h = 1e-3;
    const double slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
    EXPECT_NEAR(gradient[i], slope, 1e-7) << i;
  }
  EXPECT_GT(gradient[4], 0.5) << "the wrist opens";
}

TEST(SingularityWall, AMotionEndsAtTheWallAndNotBefore) {
  const Arm arm;
  const auto mixed = [&](double s) { return arm.at(0.5 - s); };
  const double share = arm.wall.freeShare(arm.at(0.5), arm.at(-0.5));
  EXPECT_NEAR(arm.wall.measure(mixed(share)), SingularityWall::kWall, 1e-6);
  for (int k = 0; k <= 1000; ++k) EXPECT_GE(arm.wall.measure(mixed(share * k / 1000.0)), SingularityWall::kWall);
  EXPECT_LT(arm.wall.measure(mixed(share + 1e-4)), SingularityWall::kWall);
  EXPECT_EQ(arm.wall.freeShare(arm.at(0.5), arm.at(0.3)), 1.0) << "it stays before the wall";
  EXPECT_EQ(arm.wall.freeShare(arm.at(0.5), arm.at(0.5)), 1.0) << "it does not move";
}

TEST(SingularityWall, WhatIsBehindItOnlyComesOut) {
  const Arm arm;
  ASSERT_LT(arm.wall.measure(arm.at(0.005)), SingularityWall::kWall);
  EXPECT_EQ(arm.wall.freeShare(arm.at(0.005), arm.at(0.2)), 1.0);
  EXPECT_LT(arm.wall.freeShare(arm.at(0.005), arm.at(-0.2)), 1e-6);
  EXPECT_LT(SingularityWall::kWall, SingularityWall::kFelt) << "it is felt before it blocks";
}

}  // namespace
}  // namespace hapticell::manipulation
