// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/true_arm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

Chain chainOfArm(const RobotModel& model, const Pose& X_LT = {}) {
  return Chain::create(model, model.defaultTip(), X_LT).value();
}

TEST(TrueArm, HoldsUpToEightJointsThatEachHaveAVariable) {
  EXPECT_TRUE(fitsTrueArm(chainOfArm(test::kr120())));
  EXPECT_TRUE(fitsTrueArm(chainOfArm(test::onSlides(test::panda(), 1))));
  EXPECT_FALSE(fitsTrueArm(chainOfArm(test::onSlides(test::panda(), 2))));
  EXPECT_TRUE(fitsTrueArm(chainOfArm(test::onSlides(test::panda(), 2)), 2));
  RobotModel model = test::scara();
  Joint& follower = test::addJoint(model, 4, "follow", JointType::kRevolute, {0, 0, 1}, {});
  follower.variable = -1;
  follower.mimic = Mimic{0, 1.0, 0.0};
  model.moving.pop_back();
  EXPECT_FALSE(fitsTrueArm(Chain::create(model, 5, {}).value()));
}

TEST(TrueArm, TipAndAxesAreThoseOfTheChain) {
  std::mt19937_64 random(12);
  const Pose X_LT{{0.05, -0.02, 0.3}, glm::angleAxis(0.6, glm::normalize(dvec3(1, 2, 3)))};
  for (const RobotModel& model :
       {test::kr120(), test::ur5e(), test::iiwa(), test::panda(), test::scara(), test::onSlides(test::kr120(), 2)}) {
    const Chain chain = chainOfArm(model, X_LT);
    if (!fitsTrueArm(chain)) continue;
    const kernels::TrueArm arm = trueArm(chain);
    ASSERT_EQ(static_cast<std::size_t>(arm.joints), chain.size());
    const std::vector<double> q = test::randomJoints(model, random);
    ChainPositions x{};
    std::copy(q.begin(), q.end(), x.begin());
    ChainState state;
    chain.evaluate(x, state);
    dmat3 R(1.0);
    dvec3 p(0.0);
    const auto step = [&](const double* rows, const double* to) {
      p += R * dvec3(to[0], to[1], to[2]);
      R = R * glm::transpose(dmat3(rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8]));
    };
    for (std::size_t j = 0; j < chain.size(); ++j) {
      step(arm.R[j], arm.p[j]);
      EXPECT_LT(glm::distance(R[2], state.axis_B[j]), 1e-12) << "z is the axis";
      if (arm.slides[j]) {
        p += x[j] * R[2];
      } else {
        R = R * glm::mat3_cast(glm::angleAxis(x[j], dvec3(0, 0, 1)));
      }
    }
    step(arm.R_tip, arm.p_tip);
    EXPECT_LT(glm::distance(p, state.p_BT), 1e-12);
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(R[i], state.R_BT[i]), 1e-12);
    EXPECT_GT(arm.scale, 0.0);
  }
}

}  // namespace
}  // namespace hapticell::kinematics
