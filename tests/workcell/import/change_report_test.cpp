// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/change_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

using Kind = EntityChange::Kind;

/// An SDF cell of two boxes at (1,0,0) and (0,2,0): a file with a tree that needs no other process.
constexpr const char* kCell =
    "<sdf version='1.6'><world name='w'>"
    "<model name='left'><static>true</static><pose>1 0 0 0 0 0</pose><link name='l'><visual name='v'><geometry><box>"
    "<size>0.1 0.1 0.1</size></box></geometry></visual></link></model>"
    "<model name='right'><static>true</static><pose>0 2 0 0 0 0</pose><link name='l'><visual name='v'><geometry><box>"
    "<size>0.2 0.2 0.2</size></box></geometry></visual></link></model></world></sdf>";

TEST(ChangeReport, AgainstTheImportTellsWhatWasMovedSince) {
  test::TemporaryFolder folder;
  const auto file = folder.write("cell.world", kCell);
  Diagnostics notes;
  auto tree = EntityLoader(folder.path()).loadTree(file.string(), {}, notes);
  ASSERT_TRUE(tree) << tree.error().message();
  Document document;
  const auto ids = addImported(document, std::move(tree->entities), Pose::identity());
  ASSERT_TRUE(ids);
  const auto unchanged = stateAtImport(document.state(), nullptr, notes);
  ASSERT_TRUE(unchanged) << unchanged.error().message();
  for (const EntityChange& change : compareStates(*unchanged, document.state())) {
    EXPECT_EQ(change.kind, Kind::kUnchanged) << change.name;
  }
  const Entity* moved = nullptr;
  for (const auto& entity : document.state().entities) {
    if (entity->mesh()) moved = entity.get();
  }
  ASSERT_NE(moved, nullptr);
  const std::string name = moved->name;
  ASSERT_TRUE(document.execute(SetPlacement{moved->id, Pose::translation({0, 0, 0.3}) * moved->X_WE}));
  const auto before = stateAtImport(document.state(), nullptr, notes);
  ASSERT_TRUE(before);
  int count = 0;
  for (const EntityChange& change : compareStates(*before, document.state())) {
    if (change.kind == Kind::kUnchanged) continue;
    ++count;
    EXPECT_EQ(change.name, name);
    EXPECT_EQ(change.kind, Kind::kMoved);
    EXPECT_NEAR(change.distance, 0.3, 1e-12);
  }
  EXPECT_EQ(count, 1);
}

TEST(ChangeReport, AFileThatIsGoneIsASentence) {
  test::TemporaryFolder folder;
  const auto file = folder.write("cell.world", kCell);
  Diagnostics notes;
  auto tree = EntityLoader(folder.path()).loadTree(file.string(), {}, notes);
  ASSERT_TRUE(tree);
  Document document;
  ASSERT_TRUE(addImported(document, std::move(tree->entities), Pose::identity()));
  std::filesystem::remove(file);
  const auto before = stateAtImport(document.state(), nullptr, notes);
  ASSERT_FALSE(before);
  EXPECT_THAT(before.error().message(), ::testing::HasSubstr("cell.world"));
}

}  // namespace
}  // namespace hapticell::workcell
