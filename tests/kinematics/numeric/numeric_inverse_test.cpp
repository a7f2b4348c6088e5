// SPDX-License-Identifier: Apache-2.0
#include "kinematics/numeric/numeric_inverse.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

std::unique_ptr<NumericInverse> inverseOf(const RobotModel& model) {
  auto inverse = NumericInverse::create(model, model.defaultTip());
  EXPECT_TRUE(inverse) << inverse.error().message();
  return std::move(*inverse);
}

bool withinLimits(const RobotModel& model, const std::vector<double>& q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    if (q[i] < joint.lower || q[i] > joint.upper) return false;
  }
  return true;
}

RC_GTEST_PROP(NumericInverse, SolvesEveryReachablePose, ()) {
  static const RobotModel kModels[] = {test::kr120(), test::ur5e(), test::panda(), test::scara()};
  const RobotModel& model = kModels[*rc::gen::inRange(0, 4)];
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const std::vector<double> q = test::randomJoints(model, random), q_start = test::randomJoints(model, random);
  const Pose X_BT = test::tipPose(model, q, model.defaultTip());
  const InverseSolution solution = inverseOf(model)->solve(X_BT, q_start);
  RC_ASSERT(solution.status == InverseStatus::kSolved);
  RC_ASSERT(withinLimits(model, solution.q));
  const Twist error = difference(test::tipPose(model, solution.q, model.defaultTip()), X_BT);
  RC_ASSERT(glm::length(error.linear) < 2e-9);
  RC_ASSERT(glm::length(error.angular) < 2e-9);
}

TEST(NumericInverse, FindsTheEightSolutionsOfASixAxisArm) {
  const RobotModel model = test::kr120();
  const auto inverse = inverseOf(model);
  // Near enough to the base for the arm to reach it over its back too.
  const std::vector<double> q = {0.4, -2.0, 2.3, 0.7, 0.9, -0.5};
  const Pose X_BT = test::tipPose(model, q, model.defaultTip());
  const auto solutions = inverse->solveAll(X_BT, q);
  ASSERT_EQ(solutions.size(), 8u);
  EXPECT_LT(test::largestStep(solutions[0].q, q), 1e-8) << "the nearest is the start itself";
  EXPECT_TRUE(solutions[0].within_limits);
  std::set<std::string> names;
  for (const AlternativeSolution& solution : solutions) {
    names.insert(solution.configuration);
    const Twist error = difference(test::tipPose(model, solution.q, model.defaultTip()), X_BT);
    EXPECT_LT(glm::length(error.linear) + glm::length(error.angular), 2e-9);
    EXPECT_EQ(solution.within_limits, withinLimits(model, solution.q)) << solution.configuration;
  }
  EXPECT_EQ(names.size(), 8u) << "each configuration has its own name";
}

TEST(NumericInverse, NearestTurnWithinLimits) {
  const RobotModel model = test::kr120();
  const auto inverse = inverseOf(model);
  const std::vector<double> q = {0.4, -1.1, 1.3, 0.7, 0.9, 5.9};
  const Pose X_BT = test::tipPose(model, q, model.defaultTip());
  EXPECT_LT(test::largestStep(inverse->solve(X_BT, {0.4, -1.1, 1.3, 0.7, 0.9, 5.0}).q, q), 1e-7);
  std::vector<double> turned = q;
  turned[5] -= 2 * std::numbers::pi;
  EXPECT_LT(test::largestStep(inverse->solve(X_BT, {0.4, -1.1, 1.3, 0.7, 0.9, -0.1}).q, turned), 1e-7);
  const RobotModel endless = test::scara();
  std::vector<double> far = {0.3, 1.0, 0.1, 40.0};
  const Pose X_endless = test::tipPose(endless, far, endless.defaultTip());
  far[3] += 0.4;
  EXPECT_NEAR(inverseOf(endless)->solve(X_endless, far).q[3], 40.0, 1e-7);
}

TEST(NumericInverse, TellsLimitFromUnreachable) {
  RobotModel model = test::kr120();
  const std::vector<double> q = {1.5, -1.1, 1.3, 0.7, 0.9, -0.5};
  const Pose X_BT = test::tipPose(model, q, model.defaultTip());
  for (Joint& joint : model.joints) {
    if (joint.name == "a1") joint.lower = -0.2, joint.upper = 0.2;
  }
  const auto inverse = inverseOf(model);
  const InverseSolution limited = inverse->solve(X_BT, std::vector<double>(6, 0.0));
  EXPECT_EQ(limited.status, InverseStatus::kLimit);
  EXPECT_TRUE(withinLimits(model, limited.q));
  EXPECT_GT(limited.position_error + limited.orientation_error, 0.1);
  EXPECT_EQ(inverse->solve(Pose::translation({9, 0, 0}), std::vector<double>(6, 0.0)).status,
            InverseStatus::kUnreachable);
}

TEST(NumericInverse, TellsSingularPositions) {
  const RobotModel model = test::kr120();
  const auto inverse = inverseOf(model);
  for (const double a5 : {0.0, 1e-6, 0.05, -0.6}) {
    const std::vector<double> q = {0.4, -1.1, 1.3, 0.7, a5, -0.5};
    const InverseSolution solution = inverse->solve(test::tipPose(model, q, model.defaultTip()), q);
    EXPECT_EQ(solution.status, InverseStatus::kSolved);
    EXPECT_EQ(solution.singular, std::abs(a5) < 1e-3) << a5;
    EXPECT_LT(test::largestStep(solution.q, q), 1e-4) << "where joint 4 is free, it stays";
  }
}

TEST(NumericInverse, TracksAPathWithoutJumps) {
  for (const RobotModel& model : {test::kr120(), test::ur5e(), test::panda()}) {
    const auto inverse = inverseOf(model);
    std::vector<double> q = {0.3, -1.2, 1.4, -1.3, 0.9, 0.7, 0.2};
    q.resize(model.dof());
    if (model.dof() == 7) q[3] = -1.9, q[5] = 1.6;
    const Pose X_0 = test::tipPose(model, q, model.defaultTip());
    InverseSolution solution;
    solution.q = q;
    for (int i = 1; i <= 4000; ++i) {
      const double t = i * 1e-3;
      const Twist motion{0.05 * dvec3(std::sin(2 * t), std::sin(3 * t), std::sin(t)),
                         0.2 * dvec3(std::sin(t), 0, std::sin(2.5 * t))};
      const Pose X_BT = displaced(X_0, motion);
      const std::vector<double> before = solution.q;
      inverse->solveNearest(X_BT, before, 1e-3, solution);
      ASSERT_EQ(solution.status, InverseStatus::kSolved) << model.dof() << " " << t;
      // No joint goes faster than its limit of 3 rad/s.
      ASSERT_LT(test::largestStep(solution.q, before), 0.00301);
    }
  }
}

TEST(NumericInverse, GlidesAlongTheBoundaryOutsideTheWorkspace) {
  for (const RobotModel& model : {test::kr120(), test::ur5e()}) {
    const auto inverse = inverseOf(model);
    std::vector<double> q = {0.0, -0.9, 1.2, 0.3, 0.9, 0.1};
    Pose X_BT = test::tipPose(model, q, model.defaultTip());
    const Pose X_start = X_BT;
    InverseSolution solution;
    solution.q = q;
    dvec3 p_before = X_BT.p;
    // Out, along the boundary and back in 10 s, then half a second of rest (a joint's speed bounds how fast it
    // unfolds).
    double largest_tip_step = 0.0, farthest = 0.0;
    for (int i = 0; i <= 10500; ++i) {
      const double s = std::min(1.0, i * 1e-4);
      const double out = std::sin(std::numbers::pi * s);
      X_BT.p = X_start.p + out * glm::normalize(dvec3(X_start.p.x, X_start.p.y, 0.1)) * 1.5 +
               dvec3(0, 0.4 * std::sin(4 * std::numbers::pi * s) * out, 0);
      const std::vector<double> before = solution.q;
      inverse->solveNearest(X_BT, before, 1e-3, solution);
      ASSERT_TRUE(withinLimits(model, solution.q));
      ASSERT_LT(test::largestStep(solution.q, before), 0.00301);
      const dvec3 p = test::tipPose(model, solution.q, model.defaultTip()).p;
      largest_tip_step = std::max(largest_tip_step, glm::length(p - p_before));
      farthest = std::max(farthest, solution.position_error);
      p_before = p;
    }
    EXPECT_GT(farthest, 0.3) << "the path does leave the workspace";
    // The hand moves by at most 0.75 mm a step here; the projection to a boundary (and the arm unfolding) a few times
    // that.
    EXPECT_LT(largest_tip_step, 0.008);
    EXPECT_EQ(solution.status, InverseStatus::kSolved) << "back inside, the pose is reached again";
  }
}

TEST(NumericInverse, ComesBackWithTheElbowOnItsSide) {
  const RobotModel model = test::kr120();
  const auto inverse = inverseOf(model);
  // Elbow up and down, both far from limits; the hand pulls the tip out by 1.5 m and lets it come back.
  for (const std::vector<double>& q :
       {std::vector<double>{0.1, -1.4, 1.9, 0.2, 0.6, 0.1}, {0.1, -0.3, -1.2, 0.2, 0.6, 0.1}}) {
    const Pose X_0 = test::tipPose(model, q, model.defaultTip());
    InverseSolution solution;
    solution.q = q;
    for (int i = 0; i <= 6500; ++i) {
      Pose X_BT = X_0;
      X_BT.p += 1.5 * std::sin(std::numbers::pi * std::min(1.0, i / 6000.0)) * glm::normalize(X_0.p);
      const std::vector<double> before = solution.q;
      inverse->solveNearest(X_BT, before, 1e-3, solution);
    }
    EXPECT_EQ(solution.status, InverseStatus::kSolved);
    EXPECT_LT(test::largestStep(solution.q, q), 1e-4);
  }
}

TEST(NumericInverse, RefusesAToolThatIsNoPose) {
  const RobotModel model = test::kr120();
  for (const double place : {1e200, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(NumericInverse::create(model, model.defaultTip(), Pose::translation({0.0, place, 0.0})));
}

TEST(NumericInverse, KeepsWhatTheTipDoesNotNeed) {
  RobotModel model = test::kr120();
  test::addJoint(model, 6, "finger", JointType::kPrismatic, {0, 1, 0}, {});
  const auto inverse = NumericInverse::create(model, model.findLink("flange"));
  ASSERT_TRUE(inverse);
  EXPECT_EQ((*inverse)->variables().size(), 6u);
  const std::vector<double> q = {0.4, -1.1, 1.3, 0.7, 0.9, -0.5, 0.33};
  const Pose X_BT = test::tipPose(model, q, model.findLink("flange"));
  EXPECT_EQ((*inverse)->solve(X_BT, {0, 0, 0, 0, 0.1, 0, 0.33}).q[6], 0.33);
}

}  // namespace
}  // namespace hapticell::kinematics
