// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/shapes/shapes.h"
#include "tests/workcell/document/every_command.h"
#include "workcell/format/document_io.h"

namespace hapticell::workcell {
namespace {

using test::makeSolid;
using ::testing::ElementsAre;

Entity makeArm(const std::string& name) {
  return test::makeArm(name, 0.5);
}

EntityId add(Document& document, const Entity& entity) {
  const auto id = document.execute(AddEntity{entity});
  EXPECT_TRUE(id.has_value()) << (id ? "" : id.error().message());
  return id.value_or(0);
}

std::string bytes(const Document& document) {
  return documentText(document.state(), "/cell");
}

TEST(Document, AddsFindsAndRemovesWithUndo) {
  Document document;
  const EntityId table = add(document, makeSolid("table")), part = add(document, makeSolid("part"));
  EXPECT_NE(table, part);
  ASSERT_NE(document.findByName("table"), nullptr);
  EXPECT_EQ(document.find(part)->name, "part");
  ASSERT_TRUE(document.execute(RemoveEntity{table}).has_value());
  EXPECT_EQ(document.find(table), nullptr);
  EXPECT_EQ(document.undoText(), "Remove table");
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.state().entities[0]->name, "table");  // At its old place, with its old id.
  EXPECT_EQ(document.state().entities[0]->id, table);
  EXPECT_EQ(document.redoText(), "Remove table");
}

TEST(Document, RefusesInASentenceWhatLiesTooFarFromTheOrigin) {
  Document document;
  Entity far = makeSolid("far");
  auto mesh = std::make_shared<geometry::TriangleMesh>(*far.mesh());
  for (dvec3& vertex : mesh->vertices) vertex.x += 5e5;
  far.body = Solid{mesh};
  const auto refused = document.execute(AddEntity{far});
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("500 km"));
  EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("unit"));
  const EntityId part = add(document, makeSolid("part"));
  EXPECT_TRUE(document.execute(SetPlacement{part, Pose::translation({0.0, 1990.0, 0.0})}).has_value());
  EXPECT_FALSE(document.execute(SetPlacement{part, Pose::translation({0.0, 2010.0, 0.0})}).has_value());
  EXPECT_FALSE(document.execute(SetConfiguration{part, Pose::translation({0.0, 0.0, -3e9}), {}}).has_value());
  EXPECT_EQ(document.find(part)->X_WE.p.y, 1990.0) << "a refused command changes nothing";
}

TEST(Document, NamesAreUniqueAndIdsNeverReused) {
  Document document;
  const EntityId first = add(document, makeSolid("part"));
  EXPECT_FALSE(document.execute(AddEntity{makeSolid("part")}).has_value());
  EXPECT_EQ(document.uniqueName("part"), "part 2");
  const EntityId second = add(document, makeSolid("part 2"));
  EXPECT_EQ(document.uniqueName("part"), "part 3");
  document.undo();
  const EntityId third = add(document, makeSolid("part 2"));
  EXPECT_NE(third, second);
  EXPECT_FALSE(document.execute(RenameEntity{third, "part"}).has_value());
  EXPECT_TRUE(document.execute(RenameEntity{first, "part"}).has_value());
}

TEST(Document, RobotJointsStartWithinTheirLimits) {
  Document document;
  const EntityId arm = add(document, makeArm("arm"));
  EXPECT_THAT(document.find(arm)->joints(), ElementsAre(0.5));
  EXPECT_TRUE(document.execute(SetJoints{arm, {0.7}}).has_value());
  EXPECT_FALSE(document.execute(SetJoints{arm, {0.7, 0.1}}).has_value());
  EXPECT_FALSE(document.execute(SetJoints{arm, {std::nan("")}}).has_value());
  EXPECT_FALSE(document.execute(SetTool{arm, "nowhere", {}}).has_value());
  EXPECT_TRUE(document.execute(SetTool{arm, "upper", Pose::translation({0, 0, 0.1})}).has_value());
  EXPECT_THAT(document.find(arm)->joints(), ElementsAre(0.7));
}

TEST(Document, RefusedCommandsChangeNothing) {
  Document document;
  const EntityId part = add(document, makeSolid("part"));
  document.execute(SetProperties{.id = part, .locked = true});
  const std::string before = bytes(document);
  const auto revision = document.revision();
  const double inf = std::numeric_limits<double>::infinity();
  const AddEntity nothing;
  const Command refused[] = {
      SetPlacement{part, {}},
      SetPlacement{99, {}},
      RemoveEntity{part},
      RenameEntity{part, ""},
      RenameEntity{part, "two\nlines"},
      SetProperties{.id = part, .mass = -1.0},
      SetProperties{.id = part, .mass = inf},
      SetProperties{.id = part, .color = std::array<float, 3>{2.0f, 0.0f, 0.0f}},
      SetFrames{part, {{"a", {}}, {"a", {}}}},
      SetTool{part, "base", {}},
      nothing,
      AddPairSet{{.name = "s", .safety_distance = -0.1}},
      AddPairSet{{.name = ""}},
      EditPairSet{"none", {.name = "s"}},
      RemovePairSet{"none"},
  };
  for (const Command& command : refused) {
    const auto done = document.execute(command);
    ASSERT_FALSE(done.has_value()) << commandText(command, document.state());
    EXPECT_FALSE(done.error().message().empty());
  }
  EXPECT_EQ(bytes(document), before);
  EXPECT_EQ(document.revision(), revision);
  EXPECT_EQ(document.undoText(), "Lock part");
}

TEST(Document, ADragIsOneStep) {
  Document document;
  const EntityId part = add(document, makeSolid("part"));
  document.beginCompound("Move part");
  for (int k = 1; k <= 50; ++k) document.execute(SetPlacement{part, Pose::translation({0.01 * k, 0, 0})});
  EXPECT_FALSE(document.undo());  // Not while it is open.
  document.endCompound();
  EXPECT_EQ(document.undoText(), "Move part");
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.find(part)->X_WE.p.x, 0.0);
  ASSERT_TRUE(document.redo());
  EXPECT_NEAR(document.find(part)->X_WE.p.x, 0.5, 1e-12);

  document.beginCompound("Nothing");
  document.endCompound();
  EXPECT_EQ(document.undoText(), "Move part");

  document.beginCompound("Given up");
  document.execute(SetPlacement{part, Pose::translation({9, 0, 0})});
  document.cancelCompound();
  EXPECT_NEAR(document.find(part)->X_WE.p.x, 0.5, 1e-12);
  EXPECT_EQ(document.undoText(), "Move part");
  EXPECT_FALSE(document.inCompound());
}

TEST(Document, IsDirtyUntilItStandsWhereItWasSaved) {
  Document document;
  EXPECT_FALSE(document.isDirty());
  const EntityId part = add(document, makeSolid("part"));
  EXPECT_TRUE(document.isDirty());
  document.markSaved();
  document.execute(RenameEntity{part, "other"});
  EXPECT_TRUE(document.isDirty());
  const auto revision = document.revision();
  document.undo();
  EXPECT_FALSE(document.isDirty());
  EXPECT_GT(document.revision(), revision);
  document.undo();
  EXPECT_TRUE(document.isDirty());
  add(document, makeSolid("part"));  // Looks alike, but the saved state can no longer be reached.
  EXPECT_TRUE(document.isDirty());
}

TEST(Document, PairSetsFollowNames) {
  Document document;
  const EntityId part = add(document, makeSolid("part")), table = add(document, makeSolid("table"));
  document.execute(AddPairSet{{.name = "both", .first = {"part"}, .second = {"table"}}});
  document.execute(RenameEntity{table, "bench"});
  EXPECT_THAT(document.state().pair_sets[0].second, ElementsAre("bench"));
  document.execute(RemoveEntity{part});
  EXPECT_TRUE(document.state().pair_sets.empty());  // An empty side would mean "everything".
  document.undo();
  EXPECT_THAT(document.state().pair_sets[0].first, ElementsAre("part"));
}

TEST(Document, RulesOfSinglePairsReplaceEachOtherFollowNamesAndGoWithTheirEntity) {
  Document document;
  const EntityId part = add(document, makeSolid("part")), table = add(document, makeSolid("table"));
  ASSERT_TRUE(document.execute(SetPairRules{{{.first = "part", .second = "table", .checked = false}}}));
  ASSERT_TRUE(document.execute(
      SetPairRules{{{.first = "table", .second = "part", .checked = false, .on_contact = OnContact::kPass}}}));
  ASSERT_EQ(document.state().pair_rules.size(), 1u) << "the same two, the other way round";
  document.execute(RenameEntity{table, "bench"});
  EXPECT_EQ(document.state().pair_rules[0].first, "bench");
  ASSERT_TRUE(document.execute(SetPairRules{{{.first = "part", .second = "bench"}}, "Check the pair again"}));
  EXPECT_TRUE(document.state().pair_rules.empty()) << "nothing of its own: no rule";
  EXPECT_EQ(document.undoText(), "Check the pair again");
  document.undo();
  document.execute(RemoveEntity{part});
  EXPECT_TRUE(document.state().pair_rules.empty());
  document.undo();
  EXPECT_EQ(document.state().pair_rules.size(), 1u);
  EXPECT_FALSE(document.execute(SetPairRules{{{.first = "part", .second = "nobody"}}}));
  EXPECT_FALSE(document.execute(SetPairRules{{{.first = "part", .first_part = "link", .second = "bench"}}}));
  EXPECT_FALSE(document.execute(SetPairRules{{{.first = "part", .second = "part"}}}));
  EXPECT_EQ(document.state().pair_rules.size(), 1u) << "what is refused changes nothing";
}

TEST(Document, ASnapshotSharesMeshesAndStaysAsItWas) {
  Document document;
  const EntityId part = add(document, makeSolid("part"));
  const std::vector<Entity> snapshot = document.snapshotEntities();
  const DocumentState state = document.state();
  document.execute(SetPlacement{part, Pose::translation({1, 0, 0})});
  EXPECT_EQ(snapshot[0].X_WE.p.x, 0.0);
  EXPECT_EQ(state.find(part)->X_WE.p.x, 0.0);
  EXPECT_EQ(snapshot[0].mesh().get(), document.find(part)->mesh().get());
}

/// Random commands, many of them refused.
Command anyCommand(int entities) {
  const auto id = static_cast<EntityId>(*rc::gen::inRange(1, entities + 3));
  const std::string name = "n" + std::to_string(*rc::gen::inRange(0, 8));
  const std::string other = "n" + std::to_string(*rc::gen::inRange(0, 8));
  const double value = 0.001 * *rc::gen::inRange(0, 5000);
  switch (*rc::gen::inRange(0, 13)) {
    case 0:
      return AddEntity{makeSolid(name)};
    case 1:
      return AddEntity{makeArm(name)};
    case 2:
      return RemoveEntity{id};
    case 3:
      return RenameEntity{id, name};
    case 4:
      return SetPlacement{id, {dvec3(value), quaternionFromRotationVector({value, 0, 1})}};
    case 5:
      return SetJoints{id, {value}};
    case 6:
      return SetProperties{.id = id, .color = std::array<float, 3>{0.25f, 0.5f, 0.7f}, .mass = value};
    case 7:
      return SetProperties{.id = id, .locked = value > 3.0, .on_contact = OnContact::kStop};
    case 8:
      return SetFrames{id, {{name, Pose::translation(dvec3(value))}}};
    case 9:
      return AddPairSet{{.name = name, .first = {other}, .safety_distance = value}};
    case 10:
      return EditPairSet{name, {.name = other, .second = {name}, .near_miss = value}};
    case 11:
      return RemovePairSet{name};
    default:
      return SetView{SavedView{dvec3(value), dvec3(0.0)}};
  }
}

RC_GTEST_PROP(Document, UndoingAllGivesTheSameBytesAndRedoingAllTheOthers, ()) {
  Document document;
  const std::string empty = bytes(document);
  std::vector<std::string> states{empty};
  const int commands = *rc::gen::inRange(0, 40);
  for (int k = 0; k < commands; ++k) {
    const bool compound = *rc::gen::inRange(0, 6) == 0;
    if (compound) document.beginCompound("several");
    bool changed = document.execute(anyCommand(k)).has_value();
    if (compound) {
      changed = document.execute(anyCommand(k)).has_value() || changed;
      document.endCompound();
    }
    if (changed) states.push_back(bytes(document));
  }
  for (std::size_t k = states.size() - 1; k > 0; --k) {
    RC_ASSERT(bytes(document) == states[k]);
    RC_ASSERT(document.undo());
  }
  RC_ASSERT(bytes(document) == empty);
  RC_ASSERT(!document.undo());
  RC_ASSERT(!document.isDirty());
  for (std::size_t k = 1; k < states.size(); ++k) {
    RC_ASSERT(document.redo());
    RC_ASSERT(bytes(document) == states[k]);
  }
  RC_ASSERT(!document.redo());
}

}  // namespace
}  // namespace hapticell::workcell
