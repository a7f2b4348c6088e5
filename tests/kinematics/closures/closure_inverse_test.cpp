// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/closure_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/closures/hexapod_robot.h"
#include "kinematics/closures/joint_graph.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::kinematics {
namespace {

class HexapodInverse : public ::testing::Test {
 protected:
  HexapodInverse() {
    HexapodGeometry geometry;
    for (std::size_t i = 0; i < 6; ++i) {
      const double pair = std::numbers::pi * 2.0 / 3.0 * static_cast<double>(i / 2), side = i % 2 == 0 ? -1.0 : 1.0;
      geometry.p_BA[i] = 0.6 * dvec3(std::cos(pair + 0.2 * side), std::sin(pair + 0.2 * side), 0.0);
      geometry.p_PC[i] = 0.3 * dvec3(std::cos(pair + 0.8 * side), std::sin(pair + 0.8 * side), 0.0);
    }
    HexapodOptions options;
    options.X_BPHome = Pose::translation({0, 0, 0.9});
    std::vector<JointData> joints;
    for (int k = 1; k <= 6; ++k) joints.push_back({"leg_" + std::to_string(k), 0.7, 1.4, 0.5});
    model_ = buildHexapod("hexapod", geometry, options, joints).value();
    kinematics_ = std::make_unique<HexapodKinematics>(geometry);
    tip_ = model_.findLink("platform");
  }
  Pose tipAt(const std::vector<double>& q) const {
    std::vector<Pose> X_BL;
    forwardKinematics(model_, q, X_BL);
    return X_BL[static_cast<std::size_t>(tip_)];
  }
  RobotModel model_;
  std::unique_ptr<HexapodKinematics> kinematics_;
  int tip_ = -1;
};

TEST_F(HexapodInverse, TheJacobianIsTheInverseOfTheLegs) {
  const Pose X_LT = Pose::translation({0.02, -0.05, 0.2});
  const Pose X_BP{{0.05, -0.03, 0.95}, glm::angleAxis(0.15, glm::normalize(dvec3(1, 1, 2)))};
  const LegLengths lengths = kinematics_->lengths(X_BP);
  const std::vector<double> q(lengths.begin(), lengths.end());
  Jacobian J;
  closureJacobian(model_, q, tip_, X_LT, J);
  ASSERT_EQ(J.columns, 6u);
  // Rows of the legs: how fast each grows for a motion of the tool's point, in closed form.
  Eigen::Matrix<double, 6, 6> legs, found;
  for (std::size_t k = 0; k < 6; ++k) {
    const dvec3 joint = X_BP * kinematics_->geometry().p_PC[k];
    const dvec3 along = glm::normalize(joint - kinematics_->geometry().p_BA[k]);
    const dvec3 moment = glm::cross(joint - X_BP * X_LT.p, along);
    const auto row = static_cast<Eigen::Index>(k);
    for (int c = 0; c < 3; ++c) {
      legs(row, c) = along[c];
      legs(row, 3 + c) = moment[c];
    }
    for (std::size_t r = 0; r < 6; ++r) found(static_cast<Eigen::Index>(r), row) = J(r, k);
  }
  EXPECT_LT((legs * found - Eigen::Matrix<double, 6, 6>::Identity()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(HexapodInverse, ByDifferencesItAgreesWithTheClosedFormOfTheLegs) {
  const auto inverse = ClosureInverse::create(model_, tip_, {});
  ASSERT_TRUE(inverse) << inverse.error().message();
  EXPECT_EQ((*inverse)->variables().size(), 6u);
  EXPECT_EQ((*inverse)->chain(), nullptr);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-0.08, 0.08);
  for (int i = 0; i < 10; ++i) {
    const Pose X_BP{{uniform(random), uniform(random), 0.95 + uniform(random)},
                    quaternionFromRotationVector({uniform(random), uniform(random), uniform(random)})};
    const InverseSolution solution = (*inverse)->solve(X_BP, model_.home);
    ASSERT_EQ(solution.status, InverseStatus::kSolved);
    const LegLengths wanted = kinematics_->lengths(X_BP);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(solution.q[k], wanted[k], 1e-7);
    const Twist off = difference(tipAt(solution.q), X_BP);
    EXPECT_NEAR(solution.position_error, glm::length(off.linear), 1e-9);
    EXPECT_NEAR(solution.orientation_error, glm::length(off.angular), 1e-7);
  }
}

TEST_F(HexapodInverse, SpeedAndLimitsHoldAndTheStatusSaysWhich) {
  const auto inverse = ClosureInverse::create(model_, tip_, {}).value();
  InverseSolution solution;
  inverse->solveNearest(Pose::translation({0.05, 0.0, 1.0}), model_.home, 0.01, solution);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_LE(std::abs(solution.q[k] - model_.home[k]), 0.5 * 0.01 + 1e-12);
  EXPECT_NE(solution.status, InverseStatus::kSolved) << "not in that time";
  inverse->solveNearest(Pose::translation({0.0, 0.0, 2.5}), model_.home, kUnboundedDuration, solution);
  EXPECT_EQ(solution.status, InverseStatus::kLimit);
  for (const double length : solution.q) EXPECT_LE(length, 1.4 + 1e-12);
  EXPECT_GT(tipAt(solution.q).p.z, 1.2) << "as near as the legs let it";
}

TEST_F(HexapodInverse, NothingMovesTheRoot) {
  EXPECT_FALSE(ClosureInverse::create(model_, 0, {}));
}

/// A screw on a base: modelOfGraph() makes a plain tree of it.
TEST(JointGraph, AScrewAdvancesByItsPitch) {
  JointGraph graph;
  graph.name = "screw";
  for (const char* name : {"base", "nut"}) {
    Link link;
    link.name = name;
    graph.links.push_back({link, Pose::translation({0, 0, name[0] == 'n' ? 0.1 : 0.0})});
  }
  GraphJoint screw;
  screw.joint.name = "screw";
  screw.joint.type = JointType::kRevolute;
  screw.joint.parent_link = 0;
  screw.joint.child_link = 1;
  screw.joint.lower = -30.0;
  screw.joint.upper = 30.0;
  screw.X_MJ = Pose::translation({0, 0, 0.1});
  addScrewJoint(graph, screw, 0.004);
  const auto model = modelOfGraph(graph);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->dof(), 1u);
  const int nut = model->findLink("nut");
  for (const double turns : {-1.5, 0.0, 0.25, 3.0}) {
    std::vector<Pose> X_BL;
    forwardKinematics(*model, {turns * 2.0 * std::numbers::pi}, X_BL);
    const Pose& X = X_BL[static_cast<std::size_t>(nut)];
    EXPECT_NEAR(X.p.z, 0.1 + 0.004 * turns, 1e-12);
    const dvec3 x = X.rotate({1, 0, 0});
    EXPECT_NEAR(x.x, std::cos(turns * 2.0 * std::numbers::pi), 1e-12) << "right-handed";
    EXPECT_NEAR(x.y, std::sin(turns * 2.0 * std::numbers::pi), 1e-12);
  }
}

TEST(JointGraph, ALinkThatNothingConnectsIsNamed) {
  JointGraph graph;
  for (const char* name : {"base", "lonely"}) {
    Link link;
    link.name = name;
    graph.links.push_back({link, {}});
  }
  const auto model = modelOfGraph(graph);
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message().find("lonely"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::kinematics
