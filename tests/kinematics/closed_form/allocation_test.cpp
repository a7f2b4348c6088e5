// SPDX-License-Identifier: Apache-2.0
// Counts heap allocations in the calls that the manipulation loop makes at its full rate.
#include <gtest/gtest.h>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/jacobian.h"
#include "kinematics/numeric/numeric_inverse.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/support/allocation_guard.h"

namespace hapticell::kinematics {
namespace {

TEST(Allocation, NoneInSolveNearestForwardKinematicsAndJacobian) {
  if (!hapticell::test::allocationsAreCounted()) GTEST_SKIP() << hapticell::test::kNotCounted;
  const RobotModel model = test::panda();
  const auto inverse = NumericInverse::create(model, model.defaultTip());
  ASSERT_TRUE(inverse);
  const std::vector<double> q = {0.1, 0.3, -0.2, -1.5, 0.2, 1.7, 0.4};
  const Pose X_BT = test::tipPose(model, q, model.defaultTip());
  const Pose X_far = Pose::translation({5.0, 0.0, 0.0});
  InverseSolution solution;
  std::vector<Pose> X_BL;
  Jacobian J;
  InverseJacobian inverse_jacobian;
  const auto step = [&] {
    (*inverse)->solveNearest(X_BT, q, 1e-3, solution);
    (*inverse)->solveNearest(X_far, q, kUnboundedDuration, solution);
    forwardKinematics(model, solution.q, X_BL);
    geometricJacobian(model, X_BL, model.defaultTip(), X_BL.back().p, J);
    dampedPseudoInverse(J, 1.0, 0.05, inverse_jacobian);
  };
  const hapticell::test::AllocationGuard first;
  step();
  EXPECT_GT(first.count(), 0u) << "the counter works";
  const hapticell::test::AllocationGuard second;
  step();
  EXPECT_EQ(second.count(), 0u);
}

TEST(Allocation, NoneInTheClosedForms) {
  if (!hapticell::test::allocationsAreCounted()) GTEST_SKIP() << hapticell::test::kNotCounted;
  for (const auto& make : {test::kr120, test::ur5e, test::offsetWrist}) {
    const RobotModel model = make();
    const auto inverse = createInverse(model, model.defaultTip());
    ASSERT_TRUE(inverse);
    const std::vector<double> q = {0.1, -0.9, 1.2, 0.5, 0.2, 0.7};
    const Pose X_BT = test::tipPose(model, q, model.defaultTip());
    InverseSolution solution;
    const auto step = [&] {
      (*inverse)->solveNearest(X_BT, q, 1e-3, solution);
      EXPECT_EQ(solution.status, InverseStatus::kSolved);
      (*inverse)->solveNearest(Pose::translation({5.0, 0.0, 0.0}), q, 1e-2, solution);
    };
    step();
    const hapticell::test::AllocationGuard guard;
    step();
    EXPECT_EQ(guard.count(), 0u) << (*inverse)->name();
  }
}

}  // namespace
}  // namespace hapticell::kinematics
