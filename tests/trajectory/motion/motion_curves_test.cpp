// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/motion_curves.h"

#include <gtest/gtest.h>

#include "tests/trajectory/motion/motions.h"

namespace hapticell::trajectory {
namespace {

TEST(MotionCurves, AreTheDerivativesOfAKnownMotion) {
  Trajectory motion;
  motion.joint_names = {"j"};
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.002 * i, q[1] = {0.5 * t * t * t};
    motion.addFrame({t, {{std::sin(t), 0.2 * t, 1.0}, quaternionFromRotationVector({0, 0, 2.5 * t})}}, q);
  }
  const MotionCurves curves = motionCurves(motion, 400);
  ASSERT_EQ(curves.samples, 400u);
  for (std::size_t i = 0; i < curves.samples; i += 13) {
    const double t = curves.timeOf(i);
    EXPECT_NEAR(curves.cartesian[0].value[i], std::sin(t), 1e-5);
    EXPECT_NEAR(curves.cartesian[0].speed[i], std::cos(t), 1e-3);
    EXPECT_NEAR(curves.cartesian[0].acceleration[i], -std::sin(t), 0.02);
    EXPECT_NEAR(curves.cartesian[1].speed[i], 0.2, 1e-6);
    // Four radians and more: no leap where the rotation vector would turn over.
    EXPECT_NEAR(curves.cartesian[5].value[i], 2.5 * t, 1e-6);
    EXPECT_NEAR(curves.cartesian[5].speed[i], 2.5, 1e-4);
    EXPECT_NEAR(curves.joints[0].acceleration[i], 3.0 * t, 0.02);
    EXPECT_NEAR(curves.joints[0].jerk[i], 3.0, 0.6);
    EXPECT_NEAR(curves.path.speed[i], std::hypot(std::cos(t), 0.2), 2e-3);
  }
  EXPECT_NEAR(peaksOf(curves.joints[0]).speed, 24.0, 0.01);
}

TEST(MotionCurves, OfNothingAreEmpty) {
  EXPECT_EQ(motionCurves({}).samples, 0u);
  Trajectory one;
  one.addFrame({0.0, {}});
  EXPECT_EQ(motionCurves(one).samples, 0u);
  one.addFrame({1.0, Pose::translation({1, 0, 0})});
  const MotionCurves line = motionCurves(one);
  ASSERT_GE(line.samples, 9u);
  EXPECT_NEAR(line.path.speed[4], 1.0, 1e-9);
}

}  // namespace
}  // namespace hapticell::trajectory
