// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/mounted_robot.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/closed_form/inverse_factory.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

/// A slide along x of 3 m, or a table that turns about the upright axis; a plate that does not move behind it.
RobotModel carrierOf(JointType type) {
  RobotModel model = test::emptyModel();
  model.name = "axis";
  const dvec3 axis = type == JointType::kPrismatic ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
  Joint& joint = test::addJoint(model, 0, "drive", type, axis, Pose::translation({0.2, 0.1, 0.4}));
  joint.lower = type == JointType::kPrismatic ? -1.5 : -2.5;
  joint.upper = -joint.lower;
  test::addJoint(model, 1, "plate", JointType::kFixed, {0, 0, 1}, Pose::translation({0.0, 0.0, 0.05}));
  return model;
}

std::vector<double> randomPositions(const RobotModel& model, std::mt19937& random) {
  std::vector<double> q;
  for (const int index : model.moving) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    std::uniform_real_distribution<double> place(std::max(joint.lower, -2.5), std::min(joint.upper, 2.5));
    q.push_back(place(random));
  }
  return q;
}

double apart(const Pose& a, const Pose& b) {
  return glm::length(a.p - b.p) + glm::length(rotationVector(a.q * glm::conjugate(b.q)));
}

TEST(MountedRobot, StandsWhereTheCarrierBringsIt) {
  std::mt19937 random(5);
  const RobotModel robot = test::ur5e();
  for (const JointType type : {JointType::kPrismatic, JointType::kRevolute}) {
    const RobotModel carrier = carrierOf(type);
    const Pose X_LB{{0.1, -0.2, 0.3}, quaternionFromRotationVector({0.2, 0.1, 0.7})};
    const auto mounted = mountRobot(carrier, 2, X_LB, robot);
    ASSERT_TRUE(mounted) << mounted.error().message();
    ASSERT_EQ(mounted->dof(), carrier.dof() + robot.dof());
    EXPECT_EQ(mounted->links[static_cast<std::size_t>(mounted->tip)].name, "flange");
    for (int sample = 0; sample < 20; ++sample) {
      const std::vector<double> axis = randomPositions(carrier, random), arm = randomPositions(robot, random);
      std::vector<double> all = axis;
      all.insert(all.end(), arm.begin(), arm.end());
      std::vector<Pose> X_CL, X_BL, X_ML;
      forwardKinematics(carrier, axis, X_CL);
      forwardKinematics(robot, arm, X_BL);
      forwardKinematics(*mounted, all, X_ML);
      for (std::size_t k = 0; k < X_BL.size(); ++k) {
        EXPECT_LT(apart(X_ML[carrier.links.size() + k], X_CL[2] * X_LB * X_BL[k]), 1e-12);
      }
    }
  }
}

TEST(MountedRobot, NamesThatAreThereTwiceAreToldApart) {
  const auto mounted = mountRobot(carrierOf(JointType::kPrismatic), 2, {}, test::ur5e());
  ASSERT_TRUE(mounted);
  EXPECT_EQ(mounted->links[0].name, "axis/base_link");
  EXPECT_EQ(mounted->findLink("base_link"), 3);
}

TEST(MountedRobot, ARailIsRecognisedATurntableIsSolvedByNumbers) {
  const auto on_rail = mountRobot(carrierOf(JointType::kPrismatic), 2, {}, test::ur5e());
  const auto on_table =
      mountRobot(carrierOf(JointType::kRevolute), 2, Pose::translation({0.5, 0.0, 0.0}), test::ur5e());
  ASSERT_TRUE(on_rail && on_table);
  std::mt19937 random(11);
  for (const RobotModel* model : {&*on_rail, &*on_table}) {
    const auto inverse = createInverse(*model, model->tip);
    ASSERT_TRUE(inverse);
    EXPECT_EQ((*inverse)->name(), model == &*on_rail ? "rail+ur" : "numeric");
    EXPECT_EQ((*inverse)->variables().size(), 7u);
    std::vector<double> start = restPositions(*model);
    for (int sample = 0; sample < 40; ++sample) {
      const std::vector<double> q = randomPositions(*model, random);
      std::vector<Pose> X_RL;
      forwardKinematics(*model, q, X_RL);
      const Pose X_RT = X_RL[static_cast<std::size_t>(model->tip)];
      const InverseSolution found = (*inverse)->solve(X_RT, start);
      ASSERT_EQ(found.status, InverseStatus::kSolved);
      forwardKinematics(*model, found.q, X_RL);
      EXPECT_LT(apart(X_RL[static_cast<std::size_t>(model->tip)], X_RT), 1e-5);
      start = found.q;
    }
  }
}

/// Out of reach of the arm where it stands, within reach of arm and rail together.
TEST(MountedRobot, TheRailGoesAlongWhereTheArmIsTooShort) {
  const auto on_rail = mountRobot(carrierOf(JointType::kPrismatic), 2, {}, test::ur5e());
  ASSERT_TRUE(on_rail);
  const auto inverse = createInverse(*on_rail, on_rail->tip);
  ASSERT_TRUE(inverse);
  InverseSolution at;
  at.q = {0.0, 0.2, -0.9, 1.0, 0.3, 1.1, 0.1};
  std::vector<Pose> X_RL;
  forwardKinematics(*on_rail, at.q, X_RL);
  const Pose X_RT = X_RL[static_cast<std::size_t>(on_rail->tip)];
  for (int step = 1; step <= 1000; ++step) {
    const Pose wanted{X_RT.p + dvec3(1.2e-3 * step, 0.0, 0.0), X_RT.q};
    (*inverse)->solveNearest(wanted, std::vector<double>(at.q), kUnboundedDuration, at);
    ASSERT_EQ(at.status, InverseStatus::kSolved) << step;
  }
  EXPECT_GT(at.q[0], 0.3);
}

TEST(MountedRobot, SeenFromItsPlateAMechanismStandsTheSame) {
  std::mt19937 random(3);
  RobotModel carrier = carrierOf(JointType::kRevolute);
  Joint& tilt = test::addJoint(carrier, 2, "tilt", JointType::kRevolute, {0.3, 1, 0.2}, Pose::translation({0, 0, 0.2}));
  const int plate = tilt.child_link;
  test::addJoint(carrier, 1, "arm", JointType::kPrismatic, {0, 1, 0}, Pose::translation({0.4, 0, 0}));
  Joint& follows = test::addJoint(carrier, 4, "follows", JointType::kRevolute, {1, 0, 0}, {});
  follows.variable = -1;
  follows.mimic = Mimic{carrier.findJoint("tilt"), 0.5, 0.1};
  carrier.moving.pop_back();
  const auto seen = seenFrom(carrier, plate);
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->dof(), carrier.dof());
  for (int sample = 0; sample < 20; ++sample) {
    const std::vector<double> q = randomPositions(carrier, random);
    std::vector<Pose> X_BL, X_PL;
    forwardKinematics(carrier, q, X_BL);
    forwardKinematics(*seen, q, X_PL);
    const Pose X_PB = X_BL[static_cast<std::size_t>(plate)].inverse();
    for (std::size_t k = 0; k < carrier.links.size(); ++k) {
      const int there = seen->findLink(carrier.links[k].name);
      ASSERT_GE(there, 0);
      EXPECT_LT(apart(X_PL[static_cast<std::size_t>(there)], X_PB * X_BL[k]), 1e-12) << carrier.links[k].name;
    }
  }
}

TEST(MountedRobot, LinksThatAreNotThereAndLoopsAreRefused) {
  EXPECT_FALSE(mountRobot(carrierOf(JointType::kPrismatic), 7, {}, test::ur5e()));
  EXPECT_FALSE(seenFrom(carrierOf(JointType::kPrismatic), -1));
  EXPECT_FALSE(isMoved(carrierOf(JointType::kPrismatic), 0));
  EXPECT_TRUE(isMoved(carrierOf(JointType::kPrismatic), 2));
}

}  // namespace
}  // namespace hapticell::kinematics
