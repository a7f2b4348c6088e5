// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/jacobian.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

RobotModel modelNumber(int number) {
  switch (number) {
    case 0:
      return test::kr120();
    case 1:
      return test::ur5e();
    case 2:
      return test::panda();
    case 3:
      return test::scara();
    default:
      break;
  }
  RobotModel model = test::scara();  // with a joint that mimics the first
  Joint& follower =
      test::addJoint(model, 4, "follow", JointType::kRevolute, {1, 2, 3}, Pose::translation({0.1, 0.2, 0}));
  follower.variable = -1;
  follower.mimic = Mimic{0, -1.5, 0.2};
  model.moving.pop_back();
  return model;
}

RC_GTEST_PROP(GeometricJacobian, EqualsFiniteDifferences, ()) {
  const RobotModel model = modelNumber(*rc::gen::inRange(0, 5));
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const int link = *rc::gen::inRange(1, static_cast<int>(model.links.size()));
  const std::vector<double> q = test::randomJoints(model, random);
  std::uniform_real_distribution<double> within(-0.5, 0.5);
  const dvec3 p_LQ(within(random), within(random), within(random));
  std::vector<Pose> X_BL;
  forwardKinematics(model, q, X_BL);
  Jacobian J;
  geometricJacobian(model, X_BL, link, X_BL[static_cast<std::size_t>(link)] * p_LQ, J);
  RC_ASSERT(J.columns == model.dof());
  constexpr double kStep = 1e-5;
  for (std::size_t variable = 0; variable < model.dof(); ++variable) {
    std::vector<double> less = q, more = q;
    less[variable] -= kStep;
    more[variable] += kStep;
    const Pose before = test::tipPose(model, less, link) * Pose::translation(p_LQ);
    const Pose after = test::tipPose(model, more, link) * Pose::translation(p_LQ);
    const Twist moved = difference(after, before);
    for (int row = 0; row < 3; ++row) {
      // Central differences: error of second order in the step, 1e-10 and rounding 1e-16 / 1e-5.
      RC_ASSERT(std::abs(J(static_cast<std::size_t>(row), variable) - moved.linear[row] / (2 * kStep)) < 1e-8);
      RC_ASSERT(std::abs(J(static_cast<std::size_t>(row + 3), variable) - moved.angular[row] / (2 * kStep)) < 1e-8);
    }
  }
}

RC_GTEST_PROP(DampedPseudoInverse, InvertsAwayFromSingularities, ()) {
  const RobotModel model = modelNumber(*rc::gen::inRange(0, 3));
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const std::vector<double> q = test::randomJoints(model, random);
  const int tip = model.findLink("flange");
  std::vector<Pose> X_BL;
  forwardKinematics(model, q, X_BL);
  Jacobian J;
  geometricJacobian(model, X_BL, tip, X_BL[static_cast<std::size_t>(tip)].p, J);
  RC_PRE(manipulability(J, 0.25).smallest > 0.02);
  InverseJacobian inverse;
  dampedPseudoInverse(J, 0.25, 0.02, inverse);
  for (std::size_t row = 0; row < 6; ++row) {
    for (std::size_t column = 0; column < 6; ++column) {
      double sum = 0.0;
      for (std::size_t i = 0; i < J.columns; ++i) sum += J(row, i) * inverse(i, column);
      RC_ASSERT(std::abs(sum - (row == column ? 1.0 : 0.0)) < 1e-7);
    }
  }
}

TEST(DampedPseudoInverse, StaysBoundedAtTheWristSingularity) {
  const RobotModel model = test::kr120();
  const int tip = model.findLink("flange");
  std::vector<Pose> X_BL;
  Jacobian J;
  InverseJacobian inverse;
  for (const double a5 : {0.0, 1e-9, 1e-4, 1e-2}) {
    forwardKinematics(model, {0.3, -1.2, 1.4, 0.5, a5, -0.2}, X_BL);
    geometricJacobian(model, X_BL, tip, X_BL[static_cast<std::size_t>(tip)].p, J);
    EXPECT_EQ(manipulability(J, 1.0).singular(), a5 < 1e-3) << a5;
    dampedPseudoInverse(J, 0.25, 0.05, inverse);
    for (const double value : inverse.values) {
      // At most 1 / threshold, by the lever for the linear columns.
      EXPECT_LE(std::abs(value), 1.0 / 0.05 / 0.25) << a5;
    }
  }
}

TEST(DampedPseudoInverse, ScaraMovesItsFourDirections) {
  const RobotModel model = test::scara();
  std::vector<Pose> X_BL;
  forwardKinematics(model, {0.2, 0.9, 0.05, -0.4}, X_BL);
  Jacobian J;
  geometricJacobian(model, X_BL, 4, X_BL[4].p, J);
  InverseJacobian inverse;
  dampedPseudoInverse(J, 0.25, 0.01, inverse);
  const std::size_t reachable[] = {0, 1, 2, 5};
  for (const std::size_t column : reachable) {
    for (std::size_t row = 0; row < 6; ++row) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 4; ++i) sum += J(row, i) * inverse(i, column);
      EXPECT_NEAR(sum, row == column ? 1.0 : 0.0, 1e-9);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(inverse(i, 3), 0.0, 1e-9) << "no variable tilts the tip";
}

TEST(Chain, LeavesOutWhatDoesNotMoveTheTip) {
  RobotModel model = test::kr120();
  test::addJoint(model, 6, "finger", JointType::kPrismatic, {0, 1, 0}, {});
  EXPECT_EQ(variablesOfChain(model, model.findLink("flange")), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(chainToTip(model, model.findLink("finger_link")), (std::vector<int>{0, 1, 2, 3, 4, 5, 7}));
  EXPECT_TRUE(chainToTip(model, 0).empty());
}

TEST(LimitDistances, AreSignedAndInfiniteWithoutLimits) {
  const RobotModel model = test::scara();
  const auto distances = limitDistances(model, {0.0, 2.6, 0.2, 50.0});
  EXPECT_NEAR(distances[0].to_lower, 2.5, 1e-12);
  EXPECT_NEAR(distances[1].to_upper, -0.1, 1e-12);
  EXPECT_NEAR(distances[2].to_upper, 0.02, 1e-12);
  EXPECT_TRUE(std::isinf(distances[3].to_lower) && distances[3].to_lower > 0);
}

}  // namespace
}  // namespace hapticell::kinematics
