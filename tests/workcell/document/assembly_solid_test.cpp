// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/assembly_solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/workcell/document/every_command.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;

/// The assembly "door" at x = 1 m, turned by 90 degrees about z, with two boxes below it, and a box beside it.
DocumentState doorAndTable() {
  Document document;
  Entity door;
  door.name = "door";
  door.body = Assembly{};
  door.X_WE = Pose{{1.0, 0.0, 0.0}, quaternionFromRotationVector({0.0, 0.0, 0.5 * std::numbers::pi})};
  Entity leaf = test::makeSolid("leaf", 2.0), handle = test::makeSolid("handle", 3.0);
  leaf.parent = "door";
  handle.parent = "leaf";
  for (const Entity& entity : {door, leaf, handle, test::makeSolid("table", -1.0)})
    EXPECT_TRUE(document.execute(AddEntity{entity}).has_value()) << entity.name;
  EXPECT_TRUE(document.execute(AddPairSet{{.name = "set", .first = {"handle"}, .second = {"table"}}}).has_value());
  return document.state();
}

TEST(AssemblyAsSolid, IsOneBodyWithTheShapesOfAllBelowItWhereTheyWere) {
  const DocumentState state = doorAndTable(), folded = withAssemblyAsSolid(state, "door");
  ASSERT_EQ(folded.entities.size(), 2u);
  const Entity* door = folded.findByName("door");
  ASSERT_NE(door, nullptr);
  EXPECT_EQ(door->kind(), EntityKind::kSolid);
  EXPECT_EQ(door->id, state.findByName("door")->id);
  EXPECT_EQ(folded.findByName("leaf"), nullptr);
  ASSERT_NE(door->mesh(), nullptr);
  const geometry::Bounds there = geometry::transformed(door->X_WE, door->mesh()->bounds());
  EXPECT_NEAR(there.min.x, 1.95, 1e-9);
  EXPECT_NEAR(there.max.x, 3.05, 1e-9);
  EXPECT_NEAR(there.max.y, 0.05, 1e-9);
  EXPECT_THAT(folded.pair_sets.at(0).first, ElementsAre("door")) << "a set that names a part means the whole";
  EXPECT_THAT(folded.pair_sets.at(0).second, ElementsAre("table"));
  EXPECT_EQ(state.entities.size(), 4u) << "the given state does not change";
}

TEST(AssemblyAsSolid, LeavesOtherStatesAsTheyAre) {
  const DocumentState state = doorAndTable();
  for (const char* name : {"table", "leaf", "nobody"})
    EXPECT_EQ(withAssemblyAsSolid(state, name).entities, state.entities) << name;
  Document document(state);
  Entity robot = test::makeArm("robot");
  robot.parent = "door";
  ASSERT_TRUE(document.execute(AddEntity{robot}).has_value());
  EXPECT_EQ(withAssemblyAsSolid(document.state(), "door").entities, document.state().entities)
      << "an assembly with a robot is no solid";
}

TEST(MergedMesh, HasTheVolumeOfItsPartsInTheFrameOfTheEntity) {
  const DocumentState state = doorAndTable();
  const geometry::TriangleMesh whole = mergedMesh(state, state.findByName("door")->id);
  EXPECT_EQ(whole.triangles.size(), 24u);
  // In the assembly's frame the leaf, 1 m along the cell's x from it, is at -y.
  EXPECT_NEAR(whole.bounds().max.y, -0.95, 1e-9);
  EXPECT_NEAR(whole.bounds().min.y, -2.05, 1e-9);
  EXPECT_TRUE(mergedMesh(state, 12345).triangles.empty());
}

}  // namespace
}  // namespace hapticell::workcell
