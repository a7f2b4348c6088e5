// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/state_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/workcell/document/every_command.h"
#include "workcell/document/part_resize.h"
#include "workcell/document/perform_command.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::shared_ptr<const Entity> shared(Entity entity, EntityId id) {
  entity.id = id;
  return std::make_shared<const Entity>(std::move(entity));
}

/// The box "part" (1) at x = 1 m is attached to "table" (2) at 0, and "pin" (3) at x = 2 m to the part.
DocumentState stack() {
  DocumentState state;
  Entity part = test::makeSolid("part", 1.0), pin = test::makeSolid("pin", 2.0);
  part.attachment = {"table", "", Pose::translation({1.0, 0.0, 0.0})};
  pin.attachment = {"part", "", Pose::translation({1.0, 0.0, 0.0})};
  state.entities = {shared(part, 1), shared(test::makeSolid("table"), 2), shared(pin, 3)};
  state.pair_sets = {{.name = "of part", .first = {"part"}, .second = {"table", "pin"}},
                     {.name = "of table", .first = {}, .second = {"table", "pin"}}};
  return state;
}

const Pose kQuarterTurn{dvec3(0.0), quaternionFromRotationVector({0.0, 0.0, 0.5 * std::numbers::pi})};

TEST(StateEdit, FindsWhatExistsAndWhatMayMove) {
  DocumentState state = stack();
  StateEdit edit(state, 7);
  EXPECT_EQ(edit.newId(), 7u);
  EXPECT_EQ(edit.existing(2).value()->name, "table");
  EXPECT_FALSE(edit.existing(99).has_value());
  EXPECT_TRUE(edit.movable(2).has_value());
  edit.change(2, [](Entity& table) { table.locked = true; });
  EXPECT_TRUE(edit.existing(2).has_value());
  EXPECT_THAT(edit.movable(2).error().message(), HasSubstr("'table'"));
}

TEST(StateEdit, ChangesACopyThatOtherHoldersDoNotSee) {
  DocumentState state = stack();
  const DocumentState before = state;
  EXPECT_EQ(StateEdit(state, 0).change(1, [](Entity& part) { part.visible = false; }), 1u);
  EXPECT_FALSE(state.find(1)->visible);
  EXPECT_TRUE(before.find(1)->visible);
  EXPECT_EQ(before.entities[1], state.entities[1]) << "shared as long as it does not change";
}

TEST(StateEdit, TakesAlongAllThatIsAttached) {
  DocumentState state = stack();
  StateEdit(state, 0).move(2, [](Entity& table) { table.X_WE = kQuarterTurn; });
  EXPECT_NEAR(glm::distance(state.find(1)->X_WE.p, dvec3(0.0, 1.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(state.find(3)->X_WE.p, dvec3(0.0, 2.0, 0.0)), 0.0, 1e-12) << "through the part";
}

TEST(StateEdit, StaysAttachedWhereItIsPut) {
  DocumentState state = stack();
  StateEdit edit(state, 0);
  edit.move(1, [](Entity& part) { part.X_WE = Pose::translation({0.0, 0.0, 0.5}); });
  EXPECT_NEAR(glm::distance(state.find(3)->X_WE.p, dvec3(1.0, 0.0, 0.5)), 0.0, 1e-12);
  edit.move(2, [](Entity& table) { table.X_WE.p.x = 10.0; });
  EXPECT_NEAR(glm::distance(state.find(1)->X_WE.p, dvec3(10.0, 0.0, 0.5)), 0.0, 1e-12);
}

TEST(StateEdit, MovesWhatIsBelowAnAssemblyWithIt) {
  DocumentState state = stack();
  Entity door;
  door.name = "door";
  door.body = Assembly{};
  Entity leaf = test::makeSolid("leaf", 3.0);
  leaf.parent = "door";
  state.entities.push_back(shared(door, 4));
  state.entities.push_back(shared(leaf, 5));
  StateEdit edit(state, 0);
  edit.moveFamily(*state.find(4), [](Entity& moved) { moved.X_WE = kQuarterTurn; });
  EXPECT_NEAR(glm::distance(state.find(5)->X_WE.p, dvec3(0.0, 3.0, 0.0)), 0.0, 1e-12);
  EXPECT_EQ(state.find(1)->X_WE.p, dvec3(1.0, 0.0, 0.0)) << "not below it";
}

TEST(StateEdit, ReleasesAndTakesNamesOutOfPairSets) {
  DocumentState state = stack();
  StateEdit edit(state, 0);
  edit.releaseAllFrom("table");
  EXPECT_EQ(state.find(1)->attachment.to, "");
  EXPECT_EQ(state.find(1)->X_WE.p, dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(state.find(3)->attachment.to, "part");

  edit.dropFromPairSets("pin");
  EXPECT_THAT(state.pair_sets.at(0).second, ElementsAre("table"));
  edit.dropFromPairSets("part");  // The only name of its side: without it the set would mean everything.
  ASSERT_EQ(state.pair_sets.size(), 1u);
  EXPECT_EQ(state.pair_sets[0].name, "of table");
}

TEST(StateEdit, APartThatIsTakenIntoAMechanismIsReplacedByItInTheSets) {
  DocumentState state = stack();
  state.pair_rules = {{.first = "pin", .second = "table"}, {.first = "part", .second = "table"}};
  StateEdit edit(state, 0);
  edit.takeOut(3, "hinge");
  EXPECT_EQ(state.find(3), nullptr);
  EXPECT_THAT(state.pair_sets.at(0).second, ElementsAre("table", "hinge"));
  ASSERT_EQ(state.pair_rules.size(), 1u);
  EXPECT_EQ(state.pair_rules[0].first, "part");
  edit.takeOut(2, "hinge");
  EXPECT_THAT(state.pair_sets.at(0).second, ElementsAre("hinge")) << "once";
  EXPECT_EQ(state.find(1)->attachment.to, "");
}

TEST(PerformCommand, LeavesTheStateUnchangedOnError) {
  DocumentState state = stack();
  StateEdit edit(state, 9);
  const auto before = state.entities;
  EXPECT_FALSE(perform(RenameEntity{1, "table"}, edit).has_value());
  EXPECT_FALSE(perform(RemoveEntity{42}, edit).has_value());
  EXPECT_FALSE(perform(SetJoints{1, {0.5}}, edit).has_value()) << "a solid has no joints";
  EXPECT_FALSE(perform(Attach{2, 3, ""}, edit).has_value()) << "a circle";
  EXPECT_EQ(state.entities, before);
  const auto added = perform(AddEntity{test::makeSolid("new")}, edit);
  ASSERT_TRUE(added.has_value());
  EXPECT_EQ(*added, 9u);
  EXPECT_EQ(state.entities.back()->name, "new");
}

TEST(PerformCommand, KnowsTheLinkOfTheToolAndWhatCanCarry) {
  Entity arm = test::makeArm("arm");
  EXPECT_EQ(tipOf(arm), "upper");
  arm.editJointed().tip_link = "base";
  EXPECT_EQ(tipOf(arm), "base");
  DocumentState state;
  state.entities = {shared(arm, 1)};
  Entity part = test::makeSolid("part");
  part.attachment = {"arm", "upper", {}};
  EXPECT_TRUE(checkAttachment(part, state).has_value());
  part.attachment.link = "hand";
  EXPECT_FALSE(checkAttachment(part, state).has_value());
  part.attachment = {"nobody", "", {}};
  EXPECT_FALSE(checkAttachment(part, state).has_value());
}

TEST(ResizePart, GivesTheShapeOfTheNewSizesOrSaysWhyNot) {
  const DocumentState state = stack();
  const auto commands = resizePart(state, 2, {0.2, 0.3, 0.4});
  ASSERT_TRUE(commands.has_value()) << commands.error().message();
  ASSERT_EQ(commands->size(), 1u) << "a box has its origin in the middle: nothing on it is lifted";
  const auto* shape = std::get_if<ReplaceShape>(&commands->at(0));
  ASSERT_NE(shape, nullptr);
  const geometry::Bounds bounds = shape->fresh.mesh()->bounds();
  EXPECT_NEAR(glm::distance(bounds.max - bounds.min, dvec3(0.2, 0.3, 0.4)), 0.0, 1e-12);
  EXPECT_FALSE(resizePart(state, 2, {0.2, -0.3, 0.4}).has_value());
  EXPECT_FALSE(resizePart(state, 2, {0.2}).has_value());
  EXPECT_FALSE(resizePart(state, 77, {0.2, 0.3, 0.4}).has_value());
}

TEST(ResizePart, LiftsWhatIsAttachedToATableWithItsTop) {
  DocumentState state = stack();
  Entity table = makeBuiltInPart("table:1.4,0.7,0.8", 1.0).value();
  table.name = "table";
  std::vector<double> sizes = partSizes(table.source);
  const double top = table.mesh()->bounds().max.z;
  const auto height = std::find_if(sizes.begin(), sizes.end(), [&](double s) { return std::abs(s - top) < 1e-9; });
  ASSERT_NE(height, sizes.end());
  *height += 0.1;
  state.entities[1] = shared(table, 2);
  const auto commands = resizePart(state, 2, sizes);
  ASSERT_TRUE(commands.has_value()) << commands.error().message();
  ASSERT_EQ(commands->size(), 2u);
  const auto* lifted = std::get_if<SetPlacement>(&commands->at(1));
  ASSERT_NE(lifted, nullptr);
  EXPECT_EQ(lifted->id, 1u) << "the part, not the pin on it, which the part takes along";
  EXPECT_NEAR(lifted->X_WE.p.z, 0.1, 1e-12);
}

}  // namespace
}  // namespace hapticell::workcell
