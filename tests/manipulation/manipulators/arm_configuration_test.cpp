// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/arm_configuration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity entityOf(kinematics::RobotModel model) {
  workcell::Entity robot;
  robot.name = "robot";
  robot.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model))}};
  return robot;
}

std::vector<double> anyJoints(const kinematics::RobotModel& model, std::mt19937& random) {
  std::vector<double> q;
  for (const int joint : model.moving) {
    const kinematics::Joint& j = model.joints[static_cast<std::size_t>(joint)];
    q.push_back(std::uniform_real_distribution<double>(std::max(-3.1, j.lower), std::min(3.1, j.upper))(random));
  }
  return q;
}

// Where the wrist centre and the elbow of a KR 120 are, from the poses of its links alone.
TEST(ArmConfiguration, SaysWhereWristAndElbowAre) {
  const kinematics::RobotModel model = kinematics::test::kr120();
  const auto chain = sixAxisChain(entityOf(model));
  ASSERT_TRUE(chain);
  std::mt19937 random(11);
  int checked = 0, back = 0, down = 0, flipped = 0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<double> q = anyJoints(model, random);
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(model, q, X_BL);
    const dvec3 facing = X_BL[1].rotate(dvec3(1, 0, 0)), up(0, 0, 1);
    const auto plane = [&](const dvec3& p_B) { return glm::dvec2(glm::dot(p_B, facing), glm::dot(p_B, up)); };
    const glm::dvec2 shoulder = plane(X_BL[2].p), elbow = plane(X_BL[3].p), wrist = plane(X_BL[5].p);
    const glm::dvec2 forearm = wrist - shoulder, upper = elbow - shoulder;
    const double above = forearm.x * upper.y - forearm.y * upper.x;
    if (std::abs(wrist.x) < 0.01 || std::abs(above) < 0.01 || std::abs(q[4]) < 0.01) continue;
    const auto number = configurationNumber(*chain, q);
    ASSERT_TRUE(number);
    EXPECT_EQ(*number & 1, wrist.x < 0.0 ? 1 : 0);
    if (wrist.x > 0.0) {
      EXPECT_EQ(*number & 2, above < 0.0 ? 2 : 0);
    }
    EXPECT_EQ(*number & 4, q[4] < 0.0 ? 4 : 0);
    ++checked;
    back += *number & 1;
    down += (*number & 2) / 2;
    flipped += (*number & 4) / 4;
  }
  EXPECT_GT(checked, 400);
  for (const int count : {back, down, flipped}) EXPECT_GT(count, 20) << "each of them was seen";
}

TEST(ArmConfiguration, AFlippedWristIsAnotherNumberAtTheSamePose) {
  const kinematics::RobotModel model = kinematics::test::kr120();
  const auto chain = sixAxisChain(entityOf(model));
  ASSERT_TRUE(chain);
  const std::vector<double> q{0.4, -1.1, 1.3, 0.5, 0.8, -0.2};
  const std::vector<double> other{q[0], q[1], q[2], q[3] - std::numbers::pi, -q[4], q[5] - std::numbers::pi};
  std::vector<Pose> X_BL, X_BOther;
  kinematics::forwardKinematics(model, q, X_BL);
  kinematics::forwardKinematics(model, other, X_BOther);
  ASSERT_LT(glm::length(X_BL.back().p - X_BOther.back().p), 1e-9);
  ASSERT_TRUE(configurationNumber(*chain, q));
  EXPECT_EQ(*configurationNumber(*chain, q) ^ *configurationNumber(*chain, other), 4);
}

TEST(ArmConfiguration, OnlySixAxisArmsHaveOne) {
  EXPECT_FALSE(sixAxisChain(entityOf(kinematics::test::scara())));
  EXPECT_FALSE(sixAxisChain(entityOf(kinematics::test::panda())));
  workcell::Entity solid;
  EXPECT_FALSE(sixAxisChain(solid));
  workcell::Entity robot = entityOf(kinematics::test::kr120());
  robot.editJointed().tip_link = "no link is called so";
  EXPECT_TRUE(sixAxisChain(robot)) << "the usual tip instead";
  robot.editJointed().tip_link = "a3_link";
  EXPECT_FALSE(sixAxisChain(robot)) << "only three joints move that";
  const auto chain = sixAxisChain(entityOf(kinematics::test::kr120()));
  EXPECT_FALSE(configurationNumber(*chain, std::vector<double>{0.0, -1.0, 1.0})) << "too few joints";
  const kinematics::RobotModel panda = kinematics::test::panda();
  const auto seven = kinematics::Chain::create(panda, panda.defaultTip(), {});
  ASSERT_TRUE(seven);
  EXPECT_FALSE(configurationNumber(*seven, std::vector<double>(7, -0.5)));
}

}  // namespace
}  // namespace hapticell::manipulation
