// SPDX-License-Identifier: Apache-2.0
// Arms drawn at random with axes along x, y and z, so that they are parallel, meet and lose rank as often as can be:
// every pose made from joints within limits must be solved. HAPTICELL_RANDOM_ARMS="2000 20" draws more.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/model/robot_class.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

using test::addJoint;
using test::emptyModel;

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// An offset of which each coordinate is 0 as often as not.
dvec3 offset(std::mt19937& random) {
  dvec3 p(0.0);
  for (int i = 0; i < 3; ++i) p[i] = between(random, 0.0, 1.0) < 0.45 ? between(random, -0.5, 0.5) : 0.0;
  return p;
}

RobotModel drawnArm(std::mt19937& random) {
  RobotModel model = emptyModel();
  const int joints = std::uniform_int_distribution<int>(4, 7)(random);
  for (int i = 0; i < joints; ++i) {
    dvec3 axis(0.0);
    axis[std::uniform_int_distribution<int>(0, 2)(random)] = 1.0;
    const double kind = between(random, 0.0, 1.0);
    JointType type = kind < 0.15 ? JointType::kContinuous : JointType::kRevolute;
    if (kind < 0.1) type = JointType::kPrismatic;
    Joint& joint = addJoint(model, i, test::numbered("j", static_cast<std::size_t>(i)), type, axis,
                            Pose::translation(offset(random)));
    if (type == JointType::kContinuous) continue;
    joint.lower = type == JointType::kPrismatic ? between(random, -0.5, 0.0) : between(random, -3.0, -0.3);
    joint.upper = type == JointType::kPrismatic ? between(random, 0.1, 0.6) : between(random, 0.3, 3.0);
  }
  addJoint(model, joints, "flange", JointType::kFixed, {0, 0, 1}, Pose::translation(offset(random)));
  return model;
}

std::vector<double> drawnPositions(std::mt19937& random, const RobotModel& model) {
  std::vector<double> q;
  for (const int index : model.moving) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    q.push_back(between(random, std::max(joint.lower, -3.0), std::min(joint.upper, 3.0)));
  }
  return q;
}

void expectMet(const RobotModel& model, const std::vector<double>& q, const Pose& wanted) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    ASSERT_GE(q[i], joint.lower - 1e-12);
    ASSERT_LE(q[i], joint.upper + 1e-12);
  }
  std::vector<Pose> X_BL;
  forwardKinematics(model, q, X_BL);
  const Twist left = difference(X_BL.back(), wanted);
  ASSERT_LT(glm::length(left.linear) + glm::length(left.angular), 1e-7);
}

TEST(RandomArms, EveryPoseMadeWithinLimitsIsSolved) {
  int arms = 150, poses = 8;
  if (const char* more = std::getenv("HAPTICELL_RANDOM_ARMS")) std::sscanf(more, "%d %d", &arms, &poses);
  std::mt19937 random(20261125);
  std::map<std::string, std::pair<int, int>> by_class;  // Poses, missed ones.
  for (int arm = 0; arm < arms; ++arm) {
    const RobotModel model = drawnArm(random);
    const auto inverse = createInverse(model, static_cast<int>(model.links.size()) - 1);
    ASSERT_TRUE(inverse) << inverse.error().message();
    const std::vector<double> start(model.dof(), 0.0);
    for (int pose = 0; pose < poses; ++pose) {
      const std::vector<double> q = drawnPositions(random, model);
      std::vector<Pose> X_BL;
      forwardKinematics(model, q, X_BL);
      const InverseSolution solution = (*inverse)->solve(X_BL.back(), start);
      auto& [made, missed] = by_class[(*inverse)->name()];
      ++made;
      if (solution.status == InverseStatus::kSolved) {
        ASSERT_NO_FATAL_FAILURE(expectMet(model, solution.q, X_BL.back())) << (*inverse)->name() << ", arm " << arm;
      } else {
        ++missed;
        ADD_FAILURE() << (*inverse)->name() << ", arm " << arm << " of " << model.dof() << " joints, pose " << pose
                      << ": " << toString(solution.status) << ", off by " << solution.position_error << " m, "
                      << solution.orientation_error << " rad";
      }
    }
  }
  for (const auto& [name, count] : by_class) {
    std::printf("%s: %d poses, %d missed\n", name.c_str(), count.first, count.second);
  }
}

/// Poses of joints within limits, every one of which must come back.
void expectSolves(const RobotModel& model, RobotClass robot_class, int poses) {
  const auto inverse = createInverse(model, static_cast<int>(model.links.size()) - 1);
  ASSERT_TRUE(inverse);
  EXPECT_EQ((*inverse)->name(), toString(robot_class));
  std::mt19937 random(7);
  const std::vector<double> start(model.dof(), 0.0);
  for (int k = 0; k < poses; ++k) {
    std::vector<Pose> X_BL;
    forwardKinematics(model, drawnPositions(random, model), X_BL);
    const InverseSolution solution = (*inverse)->solve(X_BL.back(), start);
    ASSERT_EQ(solution.status, InverseStatus::kSolved) << model.name << ", pose " << k;
    ASSERT_NO_FATAL_FAILURE(expectMet(model, solution.q, X_BL.back()));
  }
}

RobotModel armOf(const std::vector<std::pair<dvec3, dvec3>>& joints, const dvec3& tip) {
  RobotModel model = emptyModel();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    addJoint(model, static_cast<int>(i), test::numbered("j", i), JointType::kRevolute, joints[i].first,
             Pose::translation(joints[i].second));
  }
  addJoint(model, static_cast<int>(joints.size()), "flange", JointType::kFixed, {0, 0, 1}, Pose::translation(tip));
  return model;
}

TEST(RandomArms, SixJointsOfFiveFreedomsGoToTheNumericModel) {
  const dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), none(0.0);
  // A finger of three parallel joints behind a wrist, the same before one, and a wrist at both ends.
  expectSolves(armOf({{z, {0, 0, 0.3}}, {y, none}, {x, none}, {y, {0.3, 0, 0}}, {y, {0.2, 0, 0}}, {y, {0.1, 0, 0}}},
                     {0.1, 0, 0}),
               RobotClass::kNumeric, 60);
  expectSolves(armOf({{y, {0, 0, 0.3}}, {y, {0.4, 0, 0}}, {y, {0.3, 0, 0}}, {x, {0.2, 0, 0}}, {y, none}, {x, none}},
                     {0.1, 0, 0}),
               RobotClass::kNumeric, 60);
  expectSolves(armOf({{z, {0, 0, 0.3}}, {y, none}, {z, none}, {z, {0, 0, 0.4}}, {y, none}, {z, none}}, {0, 0, 0.1}),
               RobotClass::kNumeric, 60);
}

/// Mobile bases in URDF are two slides and a turn without limits.
TEST(RandomArms, SlidesWithoutLimitsAreSolved) {
  const dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto slide = [](RobotModel& model, int parent, const dvec3& axis) {
    Joint& joint = addJoint(model, parent, test::numbered("s", static_cast<std::size_t>(parent)), JointType::kPrismatic,
                            axis, Pose::translation({0, 0, 0.1}));
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  };
  RobotModel base = emptyModel();
  slide(base, 0, x);
  slide(base, 1, y);
  addJoint(base, 2, "turn", JointType::kContinuous, z, Pose::translation({0, 0, 0.1}));
  addJoint(base, 3, "laser", JointType::kFixed, z, Pose::translation({0.3, 0.1, 0.2}));
  expectSolves(base, RobotClass::kNumeric, 100);

  for (const double wrist : {0.0, 0.1}) {  // With a closed form and without.
    RobotModel arm = emptyModel();
    slide(arm, 0, x);
    const std::vector<std::pair<dvec3, dvec3>> joints = {{z, {0, 0, 0.4}},       {y, {0.1, 0, 0}},
                                                         {y, {0, 0, 0.5}},       {x, {0.1, 0, 0.1}},
                                                         {y, {0.4, wrist, 0.0}}, {x, {wrist, 0, 0}}};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      addJoint(arm, static_cast<int>(i) + 1, test::numbered("j", i), JointType::kRevolute, joints[i].first,
               Pose::translation(joints[i].second));
    }
    addJoint(arm, 7, "flange", JointType::kFixed, z, Pose::translation({0.1, 0, 0}));
    const auto inverse = createInverse(arm, 8);
    ASSERT_TRUE(inverse);
    std::mt19937 random(11);
    for (int k = 0; k < 60; ++k) {
      std::vector<double> q = drawnPositions(random, arm);
      q[0] *= 7.0;  // 21 m along a rail.
      std::vector<Pose> X_BL;
      forwardKinematics(arm, q, X_BL);
      const InverseSolution solution = (*inverse)->solve(X_BL.back(), std::vector<double>(arm.dof(), 0.0));
      ASSERT_EQ(solution.status, InverseStatus::kSolved) << (*inverse)->name() << ", pose " << k << ", rail " << q[0];
      ASSERT_NO_FATAL_FAILURE(expectMet(arm, solution.q, X_BL.back()));
    }
  }
}

TEST(RandomArms, APositionerWhoseTipStandsOnBothAxesIsSolved) {
  const dvec3 y(0, 1, 0), z(0, 0, 1);
  expectSolves(armOf({{y, {0, 0, 0.5}}, {z, {0, 0, 0.1}}}, dvec3(0.0)), RobotClass::kNumeric, 300);
  expectSolves(armOf({{y, dvec3(0.0)}, {z, dvec3(0.0)}}, dvec3(0.0)), RobotClass::kNumeric, 300);
}

}  // namespace
}  // namespace hapticell::kinematics
