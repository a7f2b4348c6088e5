// SPDX-License-Identifier: Apache-2.0
// What is asked of a chain's axes and positions, each by a second method.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "kinematics/model/arm_axes.h"
#include "kinematics/model/chain_report.h"
#include "kinematics/model/closure.h"
#include "kinematics/model/jacobian.h"
#include "kinematics/model/link_pose.h"
#include "kinematics/model/turns.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

Chain tipChain(const RobotModel& model, const Pose& X_LT = {}) {
  return Chain::create(model, model.defaultTip(), X_LT).value();
}

ChainPositions positionsOf(const std::vector<double>& q) {
  ChainPositions x{};
  std::copy(q.begin(), q.end(), x.begin());
  return x;
}

std::vector<RobotModel> differentRobots() {
  return {test::kr120(), test::ur5e(),          test::iiwa(),        test::panda(),
          test::scara(), test::sphericalBase(), test::offsetWrist(), test::onSlides(test::kr120(), 2)};
}

TEST(LinkPose, IsThatOfForwardKinematicsForEachLink) {
  std::mt19937_64 random(2);
  for (const RobotModel& model : differentRobots()) {
    const std::vector<double> q = test::randomJoints(model, random);
    std::vector<Pose> X_BL;
    forwardKinematics(model, q, X_BL);
    for (int link = 0; link < static_cast<int>(model.links.size()); ++link) {
      const Twist apart = difference(linkPose(model, q, link), X_BL[static_cast<std::size_t>(link)]);
      EXPECT_LT(glm::length(apart.linear) + glm::length(apart.angular), 1e-13)
          << model.links[static_cast<std::size_t>(link)].name;
    }
  }
}

/// A closure that puts every link where its index says, a metre apart, raised by the only variable.
class Row final : public Closure {
 public:
  std::string name() const override { return "row"; }
  bool pose(const std::vector<double>& q, std::vector<Pose>& X_BL) const override {
    X_BL.clear();
    for (int i = 0; i < 3; ++i) X_BL.push_back(Pose::translation({static_cast<double>(i), 0.0, i == 0 ? 0.0 : q[0]}));
    return q[0] < 1.0;
  }
  void margins(const std::vector<double>& q, std::vector<ClosureMargin>& out) const override {
    out = {{"the ceiling", 1.0 - q[0], ClosureMargin::Kind::kLength}};
  }
  Expected<std::unique_ptr<InverseModel>> inverse(const RobotModel&, int, const Pose&) const override {
    return makeError({.found = "no inverse"});
  }
};

TEST(Closure, AloneSaysWhereTheLinksStand) {
  RobotModel model = test::emptyModel();
  test::addJoint(model, 0, "lift", JointType::kPrismatic, {0, 0, 1}, Pose::translation({7, 7, 7}));
  test::addJoint(model, 1, "weld", JointType::kFixed, {0, 0, 1}, Pose::translation({7, 7, 7}));
  EXPECT_EQ(rigidBodies(model), (std::vector<int>{0, 1, 1}));
  model.closure = std::make_shared<Row>();
  std::vector<Pose> X_BL;
  forwardKinematics(model, {0.25}, X_BL);
  ASSERT_EQ(X_BL.size(), 3u);
  EXPECT_EQ(X_BL[2].p, dvec3(2.0, 0.0, 0.25)) << "the joints' frames do not count";
  EXPECT_EQ(linkPose(model, {0.25}, 1).p, dvec3(1.0, 0.0, 0.25));
  EXPECT_EQ(rigidBodies(model), (std::vector<int>{0, 1, 2})) << "the tree does not say what moves";
  std::vector<ClosureMargin> margins;
  model.closure->margins({1.5}, margins);
  ASSERT_EQ(margins.size(), 1u);
  EXPECT_LT(margins[0].value, 0.0);
}

TEST(ArmAxes, SplitsSlidesOffAndStandsAtZero) {
  const RobotModel model = test::onSlides(test::kr120(), 2);
  const ArmAxes axes = armAxes(tipChain(model));
  EXPECT_EQ(axes.rails, 2u);
  EXPECT_EQ(axes.count, 6u);
  EXPECT_TRUE(axes.simple);
  EXPECT_EQ(axes.rail_B[0], dvec3(1, 0, 0));
  EXPECT_EQ(axes.rail_B[1], dvec3(0, 1, 0));
  std::vector<Pose> X_BL;
  forwardKinematics(model, std::vector<double>(8, 0.0), X_BL);
  EXPECT_LT(glm::distance(axes.p_BT, X_BL.back().p), 1e-14);
  for (std::size_t i = 0; i < 6; ++i) {
    const Joint& joint = model.joints[i + 2];
    const Pose& X_BJ = X_BL[static_cast<std::size_t>(joint.child_link)];
    EXPECT_LT(glm::distance(axes.axis_B[i], X_BJ.rotate(joint.axis_J)), 1e-14);
    EXPECT_LT(glm::length(glm::cross(axes.origin_B[i] - X_BJ.p, axes.axis_B[i])), 1e-14);
    EXPECT_FALSE(axes.prismatic[i]);
  }
}

TEST(ArmAxes, AnArmWithAMimicJointIsNotSimple) {
  RobotModel model = test::scara();
  Joint& follower = test::addJoint(model, 4, "follow", JointType::kRevolute, {0, 0, 1}, {});
  follower.variable = -1;
  follower.mimic = Mimic{0, 1.0, 0.0};
  model.moving.pop_back();
  EXPECT_FALSE(armAxes(Chain::create(model, 5, {}).value()).simple);
}

class TwoLines : public ::testing::Test {
 protected:
  ArmAxes lines(const dvec3& o_a, const dvec3& z_a, const dvec3& o_b, const dvec3& z_b) {
    ArmAxes axes;
    axes.count = 2;
    axes.origin_B[0] = o_a;
    axes.axis_B[0] = glm::normalize(z_a);
    axes.origin_B[1] = o_b;
    axes.axis_B[1] = glm::normalize(z_b);
    return axes;
  }
  dvec3 vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  std::mt19937_64 random_{4};
  std::normal_distribution<double> normal_;
};

TEST_F(TwoLines, DistanceAndMiddleAreThoseOfLeastSquares) {
  for (int i = 0; i < 200; ++i) {
    const ArmAxes axes = lines(vector(), vector(), vector(), vector());
    Eigen::Matrix<double, 3, 2> A;
    Eigen::Vector3d b;
    for (int row = 0; row < 3; ++row) {
      A(row, 0) = axes.axis_B[0][row];
      A(row, 1) = -axes.axis_B[1][row];
      b(row) = axes.origin_B[1][row] - axes.origin_B[0][row];
    }
    const Eigen::Vector2d s = A.colPivHouseholderQr().solve(b);
    const dvec3 on_a = axes.origin_B[0] + s(0) * axes.axis_B[0], on_b = axes.origin_B[1] + s(1) * axes.axis_B[1];
    EXPECT_NEAR(lineDistance(axes, 0, 1), glm::distance(on_a, on_b), 1e-9);
    EXPECT_LT(glm::distance(nearestPoint(axes, 0, 1), 0.5 * (on_a + on_b)), 1e-6);
    EXPECT_NEAR(angleBetween(axes, 0, 1), std::acos(std::min(1.0, std::abs(glm::dot(axes.axis_B[0], axes.axis_B[1])))),
                1e-7);
    EXPECT_NEAR(distanceFromAxis(axes, on_b, 0), glm::distance(on_a, on_b), 1e-9);
  }
}

TEST_F(TwoLines, ParallelLinesHaveADistanceAndAPointBesideTheOther) {
  const ArmAxes axes = lines({0, 0, 0}, {0, 0, 1}, {3, 4, 2}, {0, 0, -1});
  EXPECT_NEAR(lineDistance(axes, 0, 1), 5.0, 1e-12);
  EXPECT_EQ(angleBetween(axes, 0, 1), 0.0) << "of lines, not of arrows";
  EXPECT_LT(glm::distance(nearestPoint(axes, 0, 1), dvec3(0, 0, 2)), 1e-12);
}

TEST(Turns, TheNearestTurnWithinLimitsIsFoundByTryingAll) {
  RobotModel model = test::ur5e();
  for (std::size_t i = 0; i < 6; ++i) {
    model.joints[i].lower = -4.0 - static_cast<double>(i);
    model.joints[i].upper = 3.5 + static_cast<double>(i);
  }
  const Chain chain = tipChain(model);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-12.0, 12.0);
  for (int trial = 0; trial < 500; ++trial) {
    ChainPositions start{}, x{};
    for (std::size_t i = 0; i < 6; ++i) {
      start[i] = std::clamp(uniform(random), chain.lower()[i], chain.upper()[i]);
      x[i] = uniform(random);
    }
    ChainPositions found = x;
    bool is_within = true;
    ChainPositions expected{};
    for (std::size_t i = 0; i < 6; ++i) {
      double best = std::numeric_limits<double>::infinity();
      for (int turns = -6; turns <= 6; ++turns) {
        const double at = x[i] + turns * kTurn;
        if (at < chain.lower()[i] || at > chain.upper()[i] || std::abs(at - start[i]) >= std::abs(best - start[i]))
          continue;
        best = at;
      }
      is_within = is_within && std::isfinite(best);
      expected[i] = best;
    }
    EXPECT_EQ(takeNearestTurns(chain, start, found), is_within);
    if (!is_within) continue;
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
    EXPECT_TRUE(sameButForTurns(chain, found, x, 1e-12));
  }
}

TEST(Turns, WhatIsOverALimitByRoundingIsPutOnIt) {
  RobotModel model = test::scara();  // joint 3 slides, and does not turn
  const Chain chain = tipChain(model);
  ChainPositions x{0.0, 0.0, 0.22 + 5e-10, 0.0};
  EXPECT_TRUE(takeNearestTurns(chain, {}, x));
  EXPECT_EQ(x[2], 0.22);
  x[2] = 0.22 + 1e-6;
  EXPECT_FALSE(takeNearestTurns(chain, {}, x));
  EXPECT_EQ(x[2], 0.22 + 1e-6) << "left where it is";
  ChainPositions a{0.1, 0.2, 0.05, 0.3}, b = a;
  b[3] += kTurn;
  b[2] += 1e-4;
  EXPECT_TRUE(sameButForTurns(chain, a, b, 2e-4));
  EXPECT_FALSE(sameButForTurns(chain, a, b, 5e-5));
  b[2] = a[2] + kTurn;
  EXPECT_FALSE(sameButForTurns(chain, a, b, 1e-3)) << "a slide does not come back after 6.28 m";
  EXPECT_NEAR(distanceSquared(chain, a, b), 2.0 * kTurn * kTurn, 1e-12);
}

TEST(ChainReport, SingularIsWhereTheLeastSingularValueVanishes) {
  std::mt19937_64 random(9);
  for (const RobotModel& model : {test::kr120(), test::ur5e(), test::sphericalWrist()}) {
    const Chain chain = tipChain(model);
    for (int i = 0; i < 60; ++i) {
      std::vector<double> q = test::randomJoints(model, random);
      if (i % 2 == 0) q[4] = 1e-4 * (i % 7);  // a stretched wrist of the first two
      std::vector<Pose> X_BL;
      forwardKinematics(model, q, X_BL);
      Jacobian J;
      geometricJacobian(model, X_BL, model.defaultTip(), X_BL.back().p, J);
      Eigen::MatrixXd scaled(6, 6);
      for (std::size_t row = 0; row < 6; ++row) {
        for (std::size_t column = 0; column < 6; ++column) {
          scaled(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
              J(row, column) * (row < 3 ? 2.0 / chain.scale() : 1.0);
        }
      }
      const double least = scaled.jacobiSvd().singularValues().minCoeff();
      if (std::abs(least - 1e-3) < 1e-5) continue;
      EXPECT_EQ(chainIsSingular(chain, positionsOf(q)), least < 1e-3) << least;
    }
  }
}

TEST(ChainReport, BranchesOfAnArmAreNamedAndOthersAreNot) {
  const Chain chain = tipChain(test::kr120());
  const std::string name = configurationName(chain, {0.1, -1.2, 1.3, 0.2, 0.6, 0.1});
  EXPECT_NE(name.find("front"), std::string::npos) << name;
  const std::string flipped =
      configurationName(chain, {0.1, -1.2, 1.3, 0.2 - std::numbers::pi, -0.6, 0.1 - std::numbers::pi});
  EXPECT_NE(name, flipped) << "the same pose with the wrist flipped";
  EXPECT_EQ(configurationName(tipChain(test::panda()), {}), "");
}

TEST(ChainReport, AnArmWithoutAllDirectionsIsDeficient) {
  EXPECT_FALSE(armIsDeficient(tipChain(test::kr120()), 0));
  EXPECT_FALSE(armIsDeficient(tipChain(test::onSlides(test::kr120(), 2)), 2));
  // Six parallel axes move in a plane.
  std::vector<std::pair<dvec3, dvec3>> planar;
  for (int i = 0; i < 6; ++i) planar.push_back({{0.2 * i, 0.1 * (i % 2), 0.0}, {0, 0, 1}});
  EXPECT_TRUE(armIsDeficient(tipChain(test::fromAxes(planar, {1.3, 0.2, 0.1})), 0));
}

}  // namespace
}  // namespace hapticell::kinematics
