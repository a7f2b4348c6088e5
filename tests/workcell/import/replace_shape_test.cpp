// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

std::string armText(double upper, const std::string& extra) {
  return "<robot name='arm'><link name='base'/><link name='l'/><joint name='j' type='revolute'><parent link='base'/>"
         "<child link='l'/><axis xyz='0 0 1'/><limit lower='-1' upper='" +
         std::to_string(upper) + "' effort='1' velocity='1'/></joint>" + extra + "</robot>";
}

TEST(ReplaceShape, ASolidKeepsItsPlaceNameAndColour) {
  test::TemporaryFolder folder;
  folder.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Diagnostics notes;
  Document document;
  auto entity = EntityLoader(folder.path()).load("part.obj", 1.0, notes);
  ASSERT_TRUE(entity);
  entity->name = "mine";
  entity->X_WE = Pose::translation({1, 2, 3});
  entity->color = {0.1f, 0.2f, 0.3f};
  const auto id = document.execute(AddEntity{*entity});
  ASSERT_TRUE(id);
  folder.write("part.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nf 1 2 3\nf 2 4 3\n");
  const auto fresh = EntityLoader(folder.path()).load("part.obj", 1.0, notes);
  ASSERT_TRUE(fresh);
  ASSERT_TRUE(document.execute(ReplaceShape{*id, *fresh}));
  const Entity& now = *document.find(*id);
  EXPECT_EQ(now.mesh()->triangles.size(), 2u);
  EXPECT_EQ(now.name, "mine");
  EXPECT_EQ(now.X_WE.p, dvec3(1, 2, 3));
  EXPECT_EQ(now.color, entity->color);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.find(*id)->mesh()->triangles.size(), 1u);
}

TEST(ReplaceShape, ARobotKeepsThePositionsOfJointsOfTheSameNameWithinTheNewLimits) {
  test::TemporaryFolder folder;
  folder.write("arm.urdf", armText(2.0, ""));
  Diagnostics notes;
  Document document;
  auto robot = EntityLoader(folder.path()).load("arm.urdf", 1.0, notes);
  ASSERT_TRUE(robot) << robot.error().message();
  robot->setJoints({1.5});
  const auto id = document.execute(AddEntity{*robot});
  ASSERT_TRUE(id);
  folder.write("arm.urdf", armText(1.2,
                                   "<link name='m'/><joint name='k' type='prismatic'><parent link='l'/>"
                                   "<child link='m'/><limit lower='0' upper='1' effort='1' velocity='1'/></joint>"));
  const auto fresh = EntityLoader(folder.path()).load("arm.urdf", 1.0, notes);
  ASSERT_TRUE(fresh) << fresh.error().message();
  ASSERT_TRUE(document.execute(ReplaceShape{*id, *fresh}));
  const Entity& now = *document.find(*id);
  ASSERT_EQ(now.joints().size(), 2u);
  EXPECT_DOUBLE_EQ(now.joints()[0], 1.2);
  EXPECT_DOUBLE_EQ(now.joints()[1], 0.0);
}

TEST(ReplaceShape, AnotherKindOfThingIsRefused) {
  Diagnostics notes;
  Document document;
  EntityLoader loader(".");
  const auto box = loader.load("box:1,1,1", 1.0, notes), robot = loader.load("library:ur5e", 1.0, notes);
  ASSERT_TRUE(box && robot);
  const auto id = document.execute(AddEntity{*box});
  ASSERT_TRUE(id);
  EXPECT_FALSE(document.execute(ReplaceShape{*id, *robot}));
  EXPECT_FALSE(document.execute(ReplaceShape{*id, Entity{}}));
  EXPECT_FALSE(document.execute(ReplaceShape{*id + 1, *box}));
  EXPECT_FALSE(document.execute(SetCollisionProxy{*id, {CollisionProxy::Kind::kConvex, 0.0, 0.0, nullptr}}));
  EXPECT_EQ(document.undoTexts().size(), 1u);
}

}  // namespace
}  // namespace hapticell::workcell
