// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/pose_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/model/chain_report.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

double cost(const Chain& chain, const ChainPositions& x, const Pose& X_BT, double lever) {
  ChainState state;
  chain.evaluate(x, state);
  const Pose X{state.p_BT, glm::normalize(glm::quat_cast(state.R_BT))};
  const Twist e = difference(X_BT, X);
  return glm::dot(e.linear, e.linear) + lever * lever * glm::dot(e.angular, e.angular);
}

TEST(PoseFit, RestsAtAMinimumOutsideTheWorkspaceInFewSteps) {
  for (const RobotModel& model : {test::kr120(), test::ur5e(), test::panda()}) {
    const auto chain = Chain::create(model, model.findLink("flange"), {});
    ASSERT_TRUE(chain);
    std::mt19937_64 random(7);
    const FitBox box{chain->lower(), chain->upper()};
    FitOptions options;
    options.max_iterations = 200;
    int total = 0;
    for (int i = 0; i < 50; ++i) {
      const std::vector<double> q = test::randomJoints(model, random);
      ChainPositions x{};
      std::copy(q.begin(), q.end(), x.begin());
      Pose X_BT = test::tipPose(model, q, model.findLink("flange"));
      const dvec3 first = chain->elements()[0].p_PJ;
      X_BT.p = first + (X_BT.p - first) * ((chain->reach() + 0.3) / glm::length(X_BT.p - first));
      const FitResult fit = fitPose(*chain, X_BT, x, box, options);
      total += fit.iterations;
      EXPECT_FALSE(fit.converged);
      // A minimum: no small allowed change of one or two variables lowers the cost, tried without any derivative.
      const double rest = cost(*chain, fit.x, X_BT, options.lever);
      for (std::size_t a = 0; a < chain->size(); ++a) {
        for (const double step : {-1e-4, 1e-4}) {
          ChainPositions moved = fit.x;
          moved[a] = std::clamp(moved[a] + step, box.lower[a], box.upper[a]);
          EXPECT_GE(cost(*chain, moved, X_BT, options.lever), rest - 1e-12);
        }
      }
    }
    EXPECT_LT(total / 50, 40) << model.dof();
  }
}

TEST(PoseFit, FreesABoundThatPointsInAgain) {
  const RobotModel model = test::kr120();
  const auto chain = Chain::create(model, model.findLink("flange"), {});
  ASSERT_TRUE(chain);
  const std::vector<double> goal = {0.2, -1.0, 1.2, 0.4, 0.8, -0.3};
  const Pose X_BT = test::tipPose(model, goal, model.findLink("flange"));
  // Starts with a joint on its bound; the goal lies inside.
  const FitResult fit =
      fitPose(*chain, X_BT, {0.2, model.joints[1].upper, 1.0, 0.4, 0.8, -0.3}, {chain->lower(), chain->upper()}, {});
  EXPECT_TRUE(fit.converged);
  EXPECT_LT(fit.position_error, 1e-9);
  EXPECT_LT(fit.orientation_error, 1e-9);
}

// At the straight position no other elbow angle brings the wrist farther from axis 2; half a turn on, none nearer.
TEST(Elbow, StandsStraightWhereTheWristIsFarthest) {
  for (const RobotModel& model : {test::kr120(), test::ur5e()}) {
    const auto chain = Chain::create(model, model.findLink("flange"), {});
    ASSERT_TRUE(chain);
    const auto elbow = findElbow(*chain);
    ASSERT_TRUE(elbow);
    // The origin of joint 4's link lies at the wrist, but for a shift along axis 2 (UR) or axis 4 (KR): none for these.
    const auto reachAt = [&](double bend) {
      std::vector<Pose> X_BL;
      forwardKinematics(model, {0.0, 0.0, elbow->straight + bend, 0.0, 0.0, 0.0}, X_BL);
      const dvec3 apart = X_BL[4].p - X_BL[2].p;
      return std::hypot(apart.x, apart.z);
    };
    for (const double bend : {-2.0, -0.3, -0.01, 0.01, 0.3, 2.0}) {
      EXPECT_LT(reachAt(bend), reachAt(0.0));
      EXPECT_GT(reachAt(std::numbers::pi + bend), reachAt(std::numbers::pi));
    }
  }
  EXPECT_FALSE(findElbow(*Chain::create(test::panda(), 8, {})));
}

TEST(Chain, RefusesATipThatNothingMoves) {
  const RobotModel model = test::kr120();
  const auto chain = Chain::create(model, 0, {});
  ASSERT_FALSE(chain);
  EXPECT_NE(chain.error().message().find("base_link"), std::string::npos);
}

TEST(Chain, EvaluatesLikeForwardKinematicsWithMimicAndTool) {
  RobotModel model = test::scara();
  Joint& follower =
      test::addJoint(model, 4, "follow", JointType::kRevolute, {1, 2, 3}, Pose::translation({0.1, 0.2, 0}));
  follower.variable = -1;
  follower.mimic = Mimic{0, -1.5, 0.2};
  model.moving.pop_back();
  const Pose X_LT{{0.1, -0.2, 0.3}, glm::angleAxis(0.7, glm::normalize(dvec3(1, 1, 0)))};
  const auto chain = Chain::create(model, 5, X_LT);
  ASSERT_TRUE(chain);
  EXPECT_EQ(chain->size(), 4u);
  EXPECT_FALSE(chain->turns(0)) << "a full turn of joint 1 is one and a half of its follower";
  EXPECT_TRUE(chain->turns(1));
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> q = test::randomJoints(model, random);
    ChainPositions x{};
    std::copy(q.begin(), q.end(), x.begin());
    ChainState state;
    chain->evaluate(x, state);
    const Pose X_BT = test::tipPose(model, q, 5) * X_LT;
    EXPECT_LT(glm::length(state.p_BT - X_BT.p), 1e-13);
    EXPECT_LT(glm::length(state.p_BT - chain->elements()[0].p_PJ), chain->reach());
    for (int column = 0; column < 3; ++column) EXPECT_LT(glm::length(state.R_BT[column] - X_BT.R()[column]), 1e-13);
  }
}

}  // namespace
}  // namespace hapticell::kinematics
