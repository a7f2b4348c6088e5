// SPDX-License-Identifier: Apache-2.0
// Counts heap allocations in the calls that the manipulation loop makes at its full rate.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "kinematics/inverse_factory.h"
#include "kinematics/jacobian.h"
#include "kinematics/numeric_inverse.h"
#include "tests/kinematics/test_robots.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace hapticell::kinematics {
namespace {

TEST(Allocation, NoneInSolveNearestForwardKinematicsAndJacobian) {
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
  step();
  const long before = allocations;
  EXPECT_GT(before, 0) << "the counter works";
  step();
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, NoneInTheClosedForms) {
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
    const long before = allocations;
    step();
    EXPECT_EQ(allocations - before, 0) << (*inverse)->name();
  }
}

}  // namespace
}  // namespace hapticell::kinematics
