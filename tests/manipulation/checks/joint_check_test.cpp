// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/joint_check.h"

#include <gtest/gtest.h>

#include <random>

#include "collision/queries/proximity_query.h"
#include "manipulation/checks/inverse_batch.h"
#include "manipulation/checks/joint_motion.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

workcell::Entity loaded(const std::string& what, workcell::EntityId id, const std::string& name, const Pose& X_WE) {
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  workcell::Entity entity = *loader.load(what, 0.0, notes);
  entity.id = id;
  entity.name = name;
  entity.X_WE = X_WE;
  if (entity.robot() && entity.joints().empty()) entity.setJoints(kinematics::restPositions(*entity.robot()));
  return entity;
}

/// A robot in a narrow place: a block, a plate under it that its base touches, and a column.
std::shared_ptr<const PreparedScene> narrowCell(double plate_top = -0.2) {
  return PreparedScene::prepare(
      {loaded("library:ur5e", 1, "robot", {}),
       loaded("box:0.3,0.6,0.4", 2, "block", Pose::translation({0.45, 0.0, 0.2})),
       loaded("box:0.1,0.1,1.2", 3, "column", Pose::translation({-0.3, 0.3, 0.6})),
       loaded("box:1.0,1.0,0.1", 4, "plate", Pose::translation({0.0, 0.0, plate_top - 0.05}))},
      {}, {});
}

std::vector<std::vector<double>> randomJoints(const PreparedScene& scene, std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  std::vector<std::vector<double>> all(count, std::vector<double>(scene.find(1)->robot()->dof()));
  for (auto& joints : all)
    for (double& q : joints) q = angle(random);
  return all;
}

TEST(JointCheck, AgreesWithTheCheckOfAHold) {
  const auto scene = narrowCell();
  auto check = JointCheck::create(scene, 1, {});
  ASSERT_TRUE(check) << check.error().message();
  std::size_t free = 0;
  for (const auto& joints : randomJoints(*scene, 150)) {
    const auto hold = collisionAt(scene, 1, joints, {});
    ASSERT_TRUE(hold);
    // A hold counts what is nearer than 1 um as touching, an exact check what meets.
    if (check->clearance(joints, 1e-3) > 0.0 && check->clearance(joints, 1e-3) < 2e-6) continue;
    EXPECT_EQ(check->isFree(joints), hold->empty()) << english(*hold) << " / " << english(check->contactAt(joints));
    EXPECT_EQ(check->contactAt(joints).empty(), check->isFree(joints));
    free += check->isFree(joints) ? 1 : 0;
  }
  EXPECT_GT(free, 10U);
  EXPECT_LT(free, 140U);
}

TEST(JointCheck, ClearanceIsTheLeastDistanceOfAnyLink) {
  const auto scene = narrowCell();
  auto check = JointCheck::create(scene, 1, {});
  ASSERT_TRUE(check);
  for (const auto& joints : randomJoints(*scene, 25)) {
    double least = 0.5;
    for (const ScenePart& link : scene->parts()) {
      if (link.entity != 1) continue;
      const workcell::Entity& robot = *scene->find(1);
      for (const ScenePart& other : scene->parts()) {
        if (other.entity == 1 || (link.link == 0)) continue;
        const auto result = collision::distance(link.mesh.collider, PreparedScene::partPose(robot, robot.X_WE, joints, link.link),
                                                other.mesh.collider, scene->find(other.entity)->X_WE);
        least = std::min(least, result.colliding ? 0.0 : result.distance);
      }
    }
    EXPECT_NEAR(check->clearance(joints, 0.5), least, 1e-9);
    if (check->isFree(joints) && least > 1e-3 && least < 0.4) {
      EXPECT_TRUE(check->isFree(joints, 0.99 * least));
      EXPECT_FALSE(check->isFree(joints, 1.01 * least));
    }
  }
}

TEST(JointCheck, ABaseInContactIsToldOnce) {
  auto check = JointCheck::create(narrowCell(0.02), 1, {});
  ASSERT_TRUE(check);
  EXPECT_NE(english(check->baseContact()).find("would touch plate"), std::string::npos);
  EXPECT_FALSE(check->isFree(check->entity().joints()));
  EXPECT_TRUE(JointCheck::create(narrowCell(), 1, {})->baseContact().empty());
  EXPECT_FALSE(JointCheck::create(narrowCell(), 2, {}));
  EXPECT_FALSE(JointCheck::create(narrowCell(), 9, {}));
}

TEST(JointCheck, WhatTouchesAtRestIsLeftOutWhereAsked) {
  auto check = JointCheck::create(narrowCell(0.02), 1, {}, RestContacts::kLeaveOut);
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->baseContact().empty()) << english(check->baseContact());
  EXPECT_NE(english(check->note()).find("plate"), std::string::npos) << english(check->note());
  EXPECT_TRUE(check->isFree(check->entity().joints())) << english(check->contactAt(check->entity().joints()));
  EXPECT_TRUE(check->fresh().isFree(check->entity().joints()));
}

TEST(InverseBatch, IsEveryFreeSolutionOfTheInverseModel) {
  const auto scene = narrowCell();
  std::vector<Pose> poses;
  for (int i = 0; i < 200; ++i)
    poses.push_back({{0.25 + 0.002 * i, -0.3 + 0.003 * i, 0.3 + 0.001 * i}, glm::angleAxis(3.0, dvec3(1, 0, 0))});
  InverseBatchOptions options;
  options.threads = 1;
  const auto one = freeInverse(scene, 1, poses, options, {});
  options.threads = 2;
  const auto two = freeInverse(scene, 1, poses, options, {});
  ASSERT_TRUE(one && two) << one.error().message();
  auto check = JointCheck::create(scene, 1, {});
  const auto inverse = inverseToTool(*scene->find(1));
  ASSERT_TRUE(inverse);
  std::size_t free = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(one->answers[i].free.size(), two->answers[i].free.size());
    std::size_t expected = 0;
    for (const auto& solution : (*inverse)->solveAll(poses[i], scene->find(1)->joints()))
      expected += solution.within_limits && check->fresh().contactAt(solution.q).empty() ? 1 : 0;
    EXPECT_EQ(one->answers[i].free.size(), expected);
    for (std::size_t k = 0; k < one->answers[i].free.size(); ++k)
      EXPECT_EQ(one->answers[i].free[k].joints, two->answers[i].free[k].joints);
    free += expected;
  }
  EXPECT_EQ(one->free, free);
  EXPECT_GT(free, 50U);
  EXPECT_GT(one->checked, free);
}

TEST(InverseBatch, EndsEarlyAtTheFirstPoseWithoutOne) {
  const auto scene = narrowCell();
  std::vector<Pose> poses(300, Pose{{0.3, 0.4, 0.6}, glm::angleAxis(3.0, dvec3(1, 0, 0))});
  poses[170].p = {5.0, 0.0, 0.0};
  InverseBatchOptions options;
  options.until_missing = true;
  const auto batch = freeInverse(scene, 1, poses, options, {});
  ASSERT_TRUE(batch);
  ASSERT_EQ(batch->answers.size(), 171U);
  EXPECT_EQ(batch->answers.back().status, kinematics::InverseStatus::kUnreachable);
  EXPECT_TRUE(batch->answers[169].isFree());
}

}  // namespace
}  // namespace hapticell::manipulation
