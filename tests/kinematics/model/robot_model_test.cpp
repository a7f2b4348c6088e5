// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/robot_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

/// exp of a screw axis (unit direction w through the point r; or a translation) by Rodrigues' formula on 4 x 4
/// matrices: the product-of-exponentials way (Brockett 1984), with nothing in common with the frame by frame product
/// under test.
glm::dmat4 screw(const dvec3& w, const dvec3& r, double angle) {
  const dmat3 W(0, w.z, -w.y, -w.z, 0, w.x, w.y, -w.x, 0);
  const dmat3 R = dmat3(1.0) + std::sin(angle) * W + (1.0 - std::cos(angle)) * (W * W);
  glm::dmat4 X(R);
  const dvec3 p = r - R * r;
  X[3] = glm::dvec4(p, 1.0);
  return X;
}

void expectPose(const Pose& X, const glm::dmat4& expected, double tolerance) {
  EXPECT_LT(glm::length(X.p - dvec3(expected[3])), tolerance);
  const dmat3 difference = X.R() - dmat3(expected);
  for (int column = 0; column < 3; ++column) EXPECT_LT(glm::length(difference[column]), tolerance);
}

TEST(ForwardKinematics, EqualsProductOfExponentialsOnKr120) {
  const RobotModel model = test::kr120();
  std::mt19937_64 random(1);
  // Screw axes at zero position, from the data sheet in base coordinates.
  const std::vector<dvec3> w = {{0, 0, -1}, {0, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  const std::vector<dvec3> r = {{0, 0, 0},       {0.35, 0, 0.675}, {1.5, 0, 0.675},
                                {2.5, 0, 0.634}, {2.5, 0, 0.634},  {2.5, 0, 0.634}};
  glm::dmat4 X_home(dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0));
  X_home[3] = glm::dvec4(2.715, 0, 0.634, 1.0);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> q = test::randomJoints(model, random);
    glm::dmat4 expected(1.0);
    for (std::size_t j = 0; j < 6; ++j) expected = expected * screw(w[j], r[j], q[j]);
    expectPose(test::tipPose(model, q, model.findLink("flange")), expected * X_home, 1e-12);
  }
}

TEST(ForwardKinematics, Kr120StandsWhereItsDataSheetSays) {
  const RobotModel model = test::kr120();
  const int flange = model.findLink("flange");
  // Upright: A2 = -90 deg, A3 = +90 deg: forearm level at 675 + 1150 + 41... the 41 mm offset points down at zero.
  const Pose upright = test::tipPose(model, {0, -std::numbers::pi / 2, std::numbers::pi / 2, 0, 0, 0}, flange);
  EXPECT_NEAR(upright.p.x, 0.35 + 1.0 + 0.215, 1e-12);
  EXPECT_NEAR(upright.p.z, 0.675 + 1.15 - 0.041, 1e-12);
  // A1 turns against z: +90 deg looks to -y.
  const Pose turned = test::tipPose(model, {std::numbers::pi / 2, 0, 0, 0, 0, 0}, flange);
  EXPECT_NEAR(turned.p.y, -2.715, 1e-12);
}

TEST(ForwardKinematics, Ur5eStandsWhereItsTableSays) {
  const RobotModel model = test::ur5e();
  const Pose zero = test::tipPose(model, std::vector<double>(6, 0.0), model.findLink("flange"));
  EXPECT_NEAR(zero.p.x, -0.425 - 0.3922, 1e-12);
  EXPECT_NEAR(zero.p.y, -(0.1333 + 0.0996), 1e-12);
  EXPECT_NEAR(zero.p.z, 0.1625 - 0.0997, 1e-12);
}

TEST(ForwardKinematics, PrismaticContinuousAndMimic) {
  RobotModel model = test::emptyModel();
  test::addJoint(model, 0, "slide", JointType::kPrismatic, {0, 1, 0}, Pose::translation({1, 0, 0}));
  test::addJoint(model, 1, "turn", JointType::kContinuous, {0, 0, 1}, Pose::translation({0, 0, 0.5}));
  Joint& follower = test::addJoint(model, 2, "follow", JointType::kPrismatic, {1, 0, 0}, {});
  follower.variable = -1;
  follower.mimic = Mimic{0, -2.0, 0.1};
  model.moving.pop_back();
  std::vector<Pose> X_BL;
  forwardKinematics(model, {0.3, std::numbers::pi / 2 + 4 * std::numbers::pi}, X_BL);
  EXPECT_LT(glm::length(X_BL[1].p - dvec3(1, 0.3, 0)), 1e-12);
  EXPECT_LT(glm::length(X_BL[2].p - dvec3(1, 0.3, 0.5)), 1e-12);
  // The follower slides by -2 * 0.3 + 0.1 along the turned x axis, which is y now.
  EXPECT_LT(glm::length(X_BL[3].p - dvec3(1, 0.3 - 0.5, 0.5)), 1e-12);
}

TEST(RobotModel, DefaultTipPrefersToolNames) {
  RobotModel model = test::kr120();
  EXPECT_EQ(model.defaultTip(), model.findLink("flange"));
  test::addJoint(model, 6, "finger", JointType::kPrismatic, {0, 1, 0}, {});
  EXPECT_EQ(model.defaultTip(), model.findLink("flange")) << "a finger moves by more joints, but is no tool";
  model.links[static_cast<std::size_t>(model.findLink("flange"))].name = "plate";
  EXPECT_EQ(model.links[static_cast<std::size_t>(model.defaultTip())].name, "finger_link");
  EXPECT_EQ(model.findLink("nothing"), -1);
  EXPECT_EQ(model.findJoint("a3"), 2);
}

}  // namespace
}  // namespace hapticell::kinematics
