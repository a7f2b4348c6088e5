// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/jog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "kinematics/closed_form/inverse_factory.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

struct Jogged {
  RobotModel model;
  std::unique_ptr<InverseModel> inverse;
  Pose X_LT = Pose::translation({0.0, 0.05, 0.12});
  Pose X_WB{{1.0, -2.0, 0.5}, glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3)))};

  explicit Jogged(RobotModel robot) : model(std::move(robot)) {
    inverse = std::move(createInverse(model, model.defaultTip(), X_LT).value());
  }
  JogRobot robot() const { return {model, *inverse, model.defaultTip(), X_LT, X_WB}; }
  Pose tcp(const std::vector<double>& q) const {
    std::vector<Pose> X_BL;
    forwardKinematics(model, q, X_BL);
    return X_WB * X_BL[static_cast<std::size_t>(model.defaultTip())] * X_LT;
  }
};

TEST(Jog, StepsGoAlongTheAxesOfTheFrameChosen) {
  const Pose X_WB{{1, 2, 3}, glm::angleAxis(0.4, dvec3(0, 0, 1))};
  const Pose X_WT{{4, 5, 6}, glm::angleAxis(1.1, dvec3(1, 0, 0))};
  const dvec3 along(0.1, 0.2, 0.3);
  EXPECT_LT(glm::length(jogged(X_WT, X_WB, {JogFrame::kWorld, along, {}}).p - (X_WT.p + along)), 1e-15);
  EXPECT_LT(glm::length(jogged(X_WT, X_WB, {JogFrame::kBase, along, {}}).p - (X_WT.p + X_WB.rotate(along))), 1e-15);
  EXPECT_LT(glm::length(jogged(X_WT, X_WB, {JogFrame::kTool, along, {}}).p - X_WT * along), 1e-15);
  const dquat R_WF = glm::angleAxis(-0.8, glm::normalize(dvec3(1, 2, 3)));
  EXPECT_LT(glm::length(jogged(X_WT, X_WB, {JogFrame::kGiven, along, {}, R_WF}).p - (X_WT.p + R_WF * along)), 1e-15);
  // A turn about an axis of the frame leaves that axis where it is, and the point.
  for (const JogFrame frame : {JogFrame::kBase, JogFrame::kTool, JogFrame::kWorld, JogFrame::kGiven}) {
    const dvec3 axis_F(0, 1, 0);
    dvec3 axis_W = axis_F;
    if (frame == JogFrame::kBase) axis_W = X_WB.rotate(axis_F);
    if (frame == JogFrame::kGiven) axis_W = R_WF * axis_F;
    if (frame == JogFrame::kTool) axis_W = X_WT.rotate(axis_F);
    const Pose after = jogged(X_WT, X_WB, {frame, {}, 0.3 * axis_F, R_WF});
    EXPECT_EQ(after.p, X_WT.p);
    const Twist turned = difference(after, X_WT);
    EXPECT_LT(glm::length(turned.angular - 0.3 * axis_W), 1e-12);
  }
}

TEST(Jog, ToolGoesStraightInOneConfiguration) {
  const Jogged arm(test::kr120());
  const std::vector<double> q{0.2, -1.2, 1.4, 0.3, 0.7, 0.1};
  for (const JogFrame frame : {JogFrame::kBase, JogFrame::kTool, JogFrame::kWorld, JogFrame::kGiven}) {
    const JogStep step{frame, {0.03, -0.02, 0.05}, {0.02, 0.05, -0.04}, glm::angleAxis(0.6, dvec3(0.6, 0.0, 0.8))};
    const JogResult result = jogTool(arm.robot(), q, step);
    ASSERT_TRUE(result.complete) << english(result.reason);
    const Pose wanted = jogged(arm.tcp(q), arm.X_WB, step), there = arm.tcp(result.q);
    EXPECT_LT(glm::length(there.p - wanted.p), 1e-6);
    EXPECT_LT(glm::length(difference(there, wanted).angular), 1e-5);
    for (std::size_t i = 0; i < q.size(); ++i) EXPECT_LT(std::abs(result.q[i] - q[i]), 0.5);
  }
}

TEST(Jog, JointStopsAtItsLimitAndSaysSo) {
  const RobotModel model = test::kr120();
  const std::vector<double> q{0.2, -1.2, 1.4, 0.3, 0.7, 0.1};
  const JogResult free = jogJoint(model, q, 4, 0.1);
  EXPECT_TRUE(free.complete);
  EXPECT_DOUBLE_EQ(free.q[4], 0.8);
  const JogResult held = jogJoint(model, q, 4, 10.0);
  EXPECT_FALSE(held.complete);
  EXPECT_DOUBLE_EQ(held.q[4], model.joints[4].upper);
  EXPECT_EQ(english(held.reason), "a5 is at its upper limit");
  EXPECT_EQ(held.q[3], q[3]);
}

TEST(Jog, ToolStopsAtAJointsLimit) {
  const Jogged arm(test::kr120());
  const std::vector<double> q{0.2, -1.2, 1.4, 0.0, 2.2, 0.1};
  // About axis 5, which is y of link a4: from 126 to past 130 degrees.
  std::vector<Pose> X_BL;
  forwardKinematics(arm.model, q, X_BL);
  const dvec3 axis_B = X_BL[5].rotate(dvec3(0, 1, 0));
  const JogResult result = jogTool(arm.robot(), q, {JogFrame::kBase, {}, 0.3 * axis_B});
  EXPECT_FALSE(result.complete);
  EXPECT_LE(result.q[4], arm.model.joints[4].upper);
  EXPECT_FALSE(result.reason.empty());
  // The way gone so far is on the way asked for: only the orientation changed.
  EXPECT_LT(glm::length(arm.tcp(result.q).p - arm.tcp(q).p), 1e-5);
}

TEST(Jog, ToolStopsAtTheEdgeOfTheReach) {
  const Jogged arm(test::ur5e());
  const std::vector<double> q{0.3, -0.4, 0.5, -0.4, 1.2, 0.2};
  const dvec3 outward = glm::normalize(arm.X_WB.inverse().rotate(arm.tcp(q).p - arm.X_WB.p));
  const JogResult result = jogTool(arm.robot(), q, {JogFrame::kBase, 3.0 * outward, {}});
  EXPECT_FALSE(result.complete);
  EXPECT_FALSE(result.reason.empty());
  EXPECT_GT(glm::length(arm.tcp(result.q).p - arm.tcp(q).p), 0.01);
}

TEST(Jog, NearestLimitNamesTheJoint) {
  RobotModel model = test::scara();
  std::vector<double> q{0.0, 0.0, 0.2188, 3.0};
  EXPECT_EQ(english(nearestLimitText(model, q, 0.01)), "j3 is 1.2 mm from its upper limit");
  EXPECT_TRUE(nearestLimitText(model, q, 1e-4).empty());
  q[1] = -2.5 + 0.0005;
  EXPECT_EQ(english(nearestLimitText(model, q, 0.01)), "j2 is at its lower limit");
}

}  // namespace
}  // namespace hapticell::kinematics
