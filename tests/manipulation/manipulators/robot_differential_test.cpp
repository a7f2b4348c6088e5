// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/robot_differential.h"

#include <gtest/gtest.h>

#include <cmath>

#include "manipulation/manipulators/symmetric.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

using kinematics::RobotModel;

const Pose kBase{dvec3(0.4, -1.0, 0.2), quaternionFromRotationVector({0.1, 0.0, 0.8})};
const Pose kTool{dvec3(0.02, 0.0, 0.15), quaternionFromRotationVector({0.0, 0.5, 0.0})};
const std::vector<double> kBent{0.3, -1.2, 1.4, 0.5, 0.9, -0.4};
const haptic::Vector6 kDirection{0.7, -0.4, 0.5, 0.6, -0.8, 0.3};

Twist times(const haptic::Vector6& xi, double h) {
  return {h * dvec3(xi[0], xi[1], xi[2]), h * dvec3(xi[3], xi[4], xi[5])};
}

template <typename Velocity, typename Acceleration>
auto expand(const Velocity& velocity, const Acceleration& acceleration, double h) {
  auto sum = 0.0 * velocity(0);
  for (std::size_t i = 0; i < 6; ++i) {
    sum += h * kDirection[i] * velocity(i);
    for (std::size_t j = 0; j < 6; ++j) {
      const std::size_t at = i <= j ? packedIndex(i, j) : packedIndex(j, i);
      sum += 0.5 * h * h * kDirection[i] * kDirection[j] * acceleration(at);
    }
  }
  return sum;
}

struct Expanded {
  RobotModel model;
  int tip;
  RobotDifferential differential;
  std::vector<Pose> X_WL;
  explicit Expanded(RobotModel robot, const std::vector<double>& start)
      : model(std::move(robot)),
        tip(model.defaultTip()),
        differential(differentiateRobot(model, start, kBase, tip, kTool)) {
    X_WL = links(start);
  }
  std::vector<Pose> links(const std::vector<double>& joints) const {
    std::vector<Pose> poses;
    kinematics::forwardKinematics(model, joints, poses);
    for (Pose& pose : poses) pose = kBase * pose;
    return poses;
  }
  std::vector<double> jointsAfter(const std::vector<double>& start, double h) const {
    std::vector<double> result = start;
    for (std::size_t k = 0; k < start.size(); ++k) {
      result[k] += expand([&](std::size_t i) { return differential.joint_velocity[k][i]; },
                          [&](std::size_t at) { return differential.joint_acceleration[k][at]; }, h);
    }
    return result;
  }
};

double tcpError(const Expanded& robot, const std::vector<double>& q, double h) {
  const auto tip = static_cast<std::size_t>(robot.tip);
  const Pose wanted = displaced(robot.X_WL[tip] * kTool, times(kDirection, h));
  const Twist left = difference(robot.links(robot.jointsAfter(q, h))[tip] * kTool, wanted);
  return glm::length(left.linear) + glm::length(left.angular);
}

TEST(RobotDifferential, JointsFollowTheToolToSecondOrder) {
  for (const RobotModel& model : {kinematics::test::kr120(), kinematics::test::ur5e()}) {
    const Expanded robot(model, kBent);
    const double coarse = tcpError(robot, kBent, 0.04), fine = tcpError(robot, kBent, 0.02);
    EXPECT_LT(fine, 2e-4) << model.name;
    // Halving the step divides a third-order remainder by eight.
    EXPECT_GT(coarse / fine, 6.5) << model.name;
    EXPECT_LT(coarse / fine, 9.5) << model.name;
  }
}

TEST(RobotDifferential, LinksFollowLikewise) {
  const Expanded robot(kinematics::test::kr120(), kBent);
  const dvec3 p_LQ(0.2, 0.1, -0.3);
  const auto error = [&](double h) {
    double worst = 0.0;
    const std::vector<Pose> moved = robot.links(robot.jointsAfter(kBent, h));
    for (std::size_t k = 1; k < moved.size(); ++k) {
      const PartDifferential& part = robot.differential.links[k];
      const dvec3 p_WQ = robot.X_WL[k] * p_LQ;
      dvec3 expected = p_WQ;
      for (std::size_t i = 0; i < 6; ++i) {
        expected += h * kDirection[i] * pointVelocity(part, p_WQ, i);
        for (std::size_t j = 0; j < 6; ++j) {
          expected += 0.5 * h * h * kDirection[i] * kDirection[j] * pointAcceleration(part, p_WQ, i, j);
        }
      }
      worst = std::max(worst, glm::length(moved[k] * p_LQ - expected));
    }
    return worst;
  };
  EXPECT_LT(error(0.02), 2e-4);
  EXPECT_GT(error(0.04) / error(0.02), 6.5);
}

TEST(RobotDifferential, EdgeOfTheWorkspaceIsWhereTheArmIsStretched) {
  // The wrist centre of the KR 120 turns about axis 2 on radii of 1.15 m and sqrt(1 + 0.041^2) m.
  const RobotModel model = kinematics::test::kr120();
  const double forearm = std::sqrt(1.0 + 0.041 * 0.041), stretched = std::atan2(-0.041, 1.0);
  for (const double angle : {0.03, 0.08}) {
    const std::vector<double> q{0.0, -0.9, stretched + angle, 0.3, 0.8, 0.0};
    const Expanded robot(model, q);
    const double reach = std::sqrt(1.15 * 1.15 + forearm * forearm + 2.0 * 1.15 * forearm * std::cos(angle));
    const double left = 1.15 + forearm - reach;
    ASSERT_TRUE(robot.differential.has_edge);
    const haptic::Constraint& edge = robot.differential.edge;
    // Metres along a unit translation: gap over the gradient's linear part (the wrist turns along at no cost).
    const double slope = std::sqrt(edge.gradient[0] * edge.gradient[0] + edge.gradient[1] * edge.gradient[1] +
                                   edge.gradient[2] * edge.gradient[2]);
    EXPECT_NEAR(edge.gap / slope, left, 0.15 * left) << angle;
  }
}

TEST(RobotDifferential, WristSingularityIsNoEdge) {
  const Expanded robot(kinematics::test::kr120(), {0.2, -1.2, 1.4, 0.5, 1e-3, -0.4});
  EXPECT_FALSE(robot.differential.has_edge && robot.differential.edge.gap < 0.001);
}

TEST(RobotDifferential, JointsStaySlowAtASingularity) {
  const Expanded robot(kinematics::test::kr120(), {0.2, -1.2, 1.4, 0.5, 0.0, -0.4});
  for (const auto& row : robot.differential.joint_velocity) {
    for (const double rate : row) EXPECT_LT(std::abs(rate), 60.0);
  }
}

}  // namespace
}  // namespace hapticell::manipulation
