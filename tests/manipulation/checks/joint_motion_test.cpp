// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

/// One arm of 1 m that turns about the cell's z axis, 50 mm thick, and a thin wall across its circle.
std::vector<workcell::Entity> armAndWall(double wall_angle) {
  kinematics::RobotModel model = kinematics::test::emptyModel();
  kinematics::test::addJoint(model, 0, "j1", kinematics::JointType::kRevolute, {0, 0, 1}, {});
  model.links[1].collisions = {{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({1.0, 0.05, 0.05})),
                                Pose::translation({0.5, 0, 0}),
                                {},
                                "box"}};
  workcell::Entity arm;
  arm.id = 1;
  arm.name = "arm";
  arm.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model)),
                              .joints = {0.0},
                              .tip_link = "j1_link"}};
  const dquat turned = glm::angleAxis(wall_angle, dvec3(0, 0, 1));
  return {arm, test::solid(2, "wall", geometry::makeBox({0.2, 1e-4, 0.2}), {turned * dvec3(0.8, 0, 0), turned})};
}

std::shared_ptr<const PreparedScene> sceneOf(std::vector<workcell::Entity> entities) {
  return PreparedScene::prepare(std::move(entities), {}, {});
}

TEST(JointMotion, FreeWayEndsWhereItWasAsked) {
  const auto motion = checkJointMotion(sceneOf(armAndWall(2.4)), 1, {1.5}, {});
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_TRUE(motion->complete);
  EXPECT_EQ(motion->joints, std::vector<double>{1.5});
  EXPECT_EQ(motion->command.id, 1u);
  EXPECT_EQ(motion->command.joints, motion->joints);
  EXPECT_NEAR(motion->time_s, 0.5, 1e-12);  // 3 rad/s
}

TEST(JointMotion, StopsBeforeAThinWall) {
  const auto motion = checkJointMotion(sceneOf(armAndWall(1.0)), 1, {2.0}, {});
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_FALSE(motion->complete);
  EXPECT_EQ(motion->obstacle, "wall");
  // The corner of the arm that meets the wall first is half its width before its middle line; the wall reaches 0.9 m.
  const double expected = 1.0 - std::atan2(0.025, 0.9);
  EXPECT_LT(motion->joints[0], expected + 0.02);
  EXPECT_GT(motion->joints[0], 1.0 - std::asin(0.025 / 0.7) - 0.01);
  EXPECT_NEAR(motion->share, motion->joints[0] / 2.0, 1e-9);
  EXPECT_EQ(english(motion->reason).find("j1_link would touch wall after"), 0U) << english(motion->reason);
}

TEST(JointMotion, PlacesAreAskedWithoutTheWay) {
  const auto scene = sceneOf(armAndWall(1.0));
  EXPECT_EQ(english(collisionAt(scene, 1, {1.0}, {}).value()), "j1_link would touch wall");
  EXPECT_TRUE(collisionAt(scene, 1, {2.0}, {}).value().empty());
}

TEST(JointMotion, WhatPassesDoesNotStopIt) {
  std::vector<workcell::Entity> cell = armAndWall(1.0);
  cell[0].contact.on_contact = workcell::OnContact::kPass;
  const auto motion = checkJointMotion(sceneOf(cell), 1, {2.0}, {});
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->complete);
}

TEST(JointMotion, BadRequestsAreSentences) {
  const auto scene = sceneOf(armAndWall(1.0));
  EXPECT_FALSE(checkJointMotion(scene, 7, {0.1}, {}));
  EXPECT_FALSE(checkJointMotion(scene, 2, {0.1}, {}));
  EXPECT_FALSE(checkJointMotion(scene, 1, {0.1, 0.2}, {}));
  EXPECT_FALSE(checkJointMotion(scene, 1, {std::nan("")}, {}));
  const auto over = checkJointMotion(scene, 1, {2.6}, {});
  ASSERT_FALSE(over);
  EXPECT_NE(over.error().message().find("j1 would be 5.7 deg over its upper limit"), std::string::npos)
      << over.error().message();
}

}  // namespace
}  // namespace hapticell::manipulation
