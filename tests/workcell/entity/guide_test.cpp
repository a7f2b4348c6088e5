// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/guide.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

EntityId addBox(Document& document, const std::string& name) {
  Diagnostics diagnostics;
  auto entity = EntityLoader(".").load("box:0.1,0.1,0.1", 1.0, diagnostics);
  entity->name = name;
  return *document.execute(AddEntity{*entity});
}

Guide hinge() {
  Guide guide;
  guide.name = "door hinge";
  guide.kind = GuideKind::kHinge;
  guide.entity = "door";
  guide.X_WG = Pose::translation({0.5, 0.25, 0.0});
  guide.lower = 0.0;
  guide.upper = 1.2;
  guide.friction = 0.3;
  guide.detents = {0.0, 0.6};
  return guide;
}

TEST(Guide, IsAddedChangedRemovedAndUndone) {
  Document document;
  addBox(document, "door");
  ASSERT_TRUE(document.execute(AddGuide{hinge()}).has_value());
  Guide wider = hinge();
  wider.upper = 1.5;
  wider.name = "wide";
  ASSERT_TRUE(document.execute(EditGuide{"door hinge", wider}).has_value());
  EXPECT_EQ(document.undoText(), "Change guide door hinge");
  EXPECT_EQ(document.state().guides.at(0).upper, 1.5);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.state().guides.at(0).name, "door hinge");
  ASSERT_TRUE(document.execute(RemoveGuide{"door hinge"}).has_value());
  EXPECT_TRUE(document.state().guides.empty());
  ASSERT_TRUE(document.undo());
  EXPECT_NE(document.state().findGuide("door hinge"), nullptr);
}

TEST(Guide, GoesWithItsEntity) {
  Document document;
  const EntityId door = addBox(document, "door");
  ASSERT_TRUE(document.execute(AddGuide{hinge()}).has_value());
  ASSERT_TRUE(document.execute(RenameEntity{door, "gate"}).has_value());
  EXPECT_EQ(document.state().guides.at(0).entity, "gate");
  ASSERT_TRUE(document.execute(RemoveEntity{door}).has_value());
  EXPECT_TRUE(document.state().guides.empty());
}

TEST(Guide, RefusesNonsenseAndLeavesTheDocument) {
  Document document;
  addBox(document, "door");
  std::vector<Guide> bad(7, hinge());
  bad[0].entity = "nobody";
  bad[1].radius = -1.0;
  bad[2].friction = std::numeric_limits<double>::quiet_NaN();
  bad[3].lower = 2.0;
  bad[4].name.clear();
  bad[5].kind = GuideKind::kTube;
  bad[6].X_WG.p.x = std::numeric_limits<double>::infinity();
  for (const Guide& guide : bad) EXPECT_FALSE(document.execute(AddGuide{guide}).has_value());
  EXPECT_TRUE(document.state().guides.empty());
  ASSERT_TRUE(document.execute(AddGuide{hinge()}).has_value());
  EXPECT_FALSE(document.execute(AddGuide{hinge()}).has_value()) << "the name is taken";
}

TEST(Guide, IsSavedAndReadAgain) {
  const test::TemporaryFolder folder;
  Document document;
  addBox(document, "door");
  Guide tube = hinge();
  tube.name = "tube";
  tube.kind = GuideKind::kTube;
  tube.path = {dvec3(0.0), dvec3(0.1, 0.2, 0.3)};
  tube.help = 20.0;
  tube.lower.reset();
  tube.locked = {true, false, false, false, true, false};
  ASSERT_TRUE(document.execute(AddGuide{hinge()}).has_value());
  ASSERT_TRUE(document.execute(AddGuide{tube}).has_value());
  const auto file = folder.path() / "door.hcell";
  ASSERT_TRUE(saveDocument(document, file).has_value());
  Diagnostics diagnostics;
  const auto read = loadDocument(file, diagnostics);
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_TRUE(diagnostics.warnings.empty());
  ASSERT_EQ(read->state().guides.size(), 2U);
  const Guide& first = read->state().guides[0];
  EXPECT_EQ(first.kind, GuideKind::kHinge);
  EXPECT_EQ(first.X_WG.p, hinge().X_WG.p);
  EXPECT_EQ(first.upper, 1.2);
  EXPECT_EQ(first.detents, hinge().detents);
  EXPECT_EQ(first.friction, 0.3);
  const Guide& second = read->state().guides[1];
  EXPECT_EQ(second.path, tube.path);
  EXPECT_FALSE(second.lower.has_value());
  EXPECT_EQ(second.locked, tube.locked);
  EXPECT_EQ(second.help, 20.0);
}

}  // namespace
}  // namespace hapticell::workcell
