// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/closed_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

struct Arm {
  std::string name;
  RobotModel model;
  RobotClass robot_class;
  double tolerance;  // of the pose, m and rad
};

std::vector<Arm> arms() {
  return {{"kr120", test::kr120(), RobotClass::kOpw, 1e-12},
          {"ur5e", test::ur5e(), RobotClass::kUr, 1e-12},
          {"iiwa", test::iiwa(), RobotClass::kSrs, 1e-12},
          {"panda", test::panda(), RobotClass::kPanda, 1e-11},
          {"scara", test::scara(), RobotClass::kScara, 1e-12},
          {"sphericalWrist", test::sphericalWrist(), RobotClass::kSphericalWrist, 1e-9},
          {"sphericalBase", test::sphericalBase(), RobotClass::kSphericalBase, 1e-9},
          {"offsetWrist", test::offsetWrist(), RobotClass::kOffsetWrist, 1e-9},
          {"offsetWristAlongAxisFive", test::offsetWristAlongAxisFive(), RobotClass::kOffsetWrist, 1e-9},
          {"offsetWristWithShoulder", test::offsetWristWithShoulder(), RobotClass::kOffsetWrist, 1e-9}};
}

double poseError(const Chain& chain, const ChainPositions& x, const dmat3& R_BT, const dvec3& p_BT) {
  ChainState state;
  chain.evaluate(x, state);
  double worst = glm::length(state.p_BT - p_BT);
  for (int column = 0; column < 3; ++column) worst = std::max(worst, glm::length(state.R_BT[column] - R_BT[column]));
  return worst;
}

class ClosedFormOf : public testing::TestWithParam<Arm> {};

TEST_P(ClosedFormOf, FindsTheJointsThatMadeThePoseAndOnlyTrueSolutions) {
  const Arm& arm = GetParam();
  const auto chain = Chain::create(arm.model, arm.model.defaultTip(), Pose::identity());
  ASSERT_TRUE(chain);
  ASSERT_EQ(classify(*chain).robot_class, arm.robot_class);
  const ArmAxes axes = armAxes(*chain);
  const auto closed = makeClosedForm(arm.robot_class, axes);
  ASSERT_TRUE(closed);
  std::mt19937_64 random(7);
  int found = 0, solutions_seen = 0;
  double worst = 0.0;
  constexpr int kPoses = 1000;
  for (int i = 0; i < kPoses; ++i) {
    const std::vector<double> q = test::randomJoints(arm.model, random);
    ChainPositions x{};
    std::copy(q.begin(), q.end(), x.begin());
    ChainState state;
    chain->evaluate(x, state);
    kernels::Solutions solutions;
    const double redundant = closed->redundancyAt(state.R_BT, state.p_BT, q.data());
    closed->solve(state.R_BT, state.p_BT, redundant, q.data(), solutions);
    double nearest = 10.0;
    for (int k = 0; k < 4 * closed->groups(); ++k) {
      if ((solutions.valid >> k & 1u) == 0) continue;
      ++solutions_seen;
      ChainPositions answer{};
      double distance = 0.0;
      for (std::size_t j = 0; j < q.size(); ++j) {
        answer[j] = solutions.q[j][k];
        const bool turns = chain->turns(j);
        const double off = answer[j] - q[j];
        distance = std::max(distance, std::abs(turns ? std::remainder(off, 2.0 * std::numbers::pi) : off));
      }
      worst = std::max(worst, poseError(*chain, answer, state.R_BT, state.p_BT));
      nearest = std::min(nearest, distance);
    }
    found += nearest < 1e-5 ? 1 : 0;
    if (nearest >= 1e-5) {
      ADD_FAILURE() << arm.name << " pose " << i << " nearest " << nearest;
      if (i - found > 5) break;
    }
  }
  EXPECT_LT(worst, arm.tolerance);
  EXPECT_GT(solutions_seen, kPoses);
}

INSTANTIATE_TEST_SUITE_P(Arms, ClosedFormOf, testing::ValuesIn(arms()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(ClosedFormRing, GivesWhatEachSwivelAloneGives) {
  const RobotModel model = test::iiwa();
  const Chain chain = Chain::create(model, model.defaultTip(), {}).value();
  const auto form = makeClosedForm(RobotClass::kSrs, armAxes(chain));
  ChainPositions x{0.4, -0.6, 0.3, 1.2, -0.5, 0.9, 0.2};
  ChainState state;
  chain.evaluate(x, state);
  kernels::SwivelRing ring;
  const double first = 0.37;
  ASSERT_TRUE(form->ring(state.R_BT, state.p_BT, first, x.data(), ring));
  for (int k = 0; k < kernels::kRingSize; ++k) {
    const double swivel = first + k * 2.0 * std::numbers::pi / kernels::kRingSize;
    kernels::Solutions alone, of_ring;
    form->solve(state.R_BT, state.p_BT, swivel, x.data(), alone);
    form->ofRing(ring, k, of_ring);
    ASSERT_EQ(alone.valid, of_ring.valid);
    for (int joint = 0; joint < 7; ++joint) {
      for (int slot = 0; slot < 8; ++slot) {
        const double apart = alone.q[joint][slot] - of_ring.q[joint][slot];
        ASSERT_NEAR(std::remainder(apart, 2.0 * std::numbers::pi), 0.0, 1e-12) << k << " " << joint << " " << slot;
      }
    }
  }
}

}  // namespace
}  // namespace hapticell::kinematics
