// SPDX-License-Identifier: Apache-2.0
// Frames of the cell: entities without a shape that others are placed by and hang on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/document/carried_load.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/files/pack.h"
#include "workcell/entity/pair_policy.h"
#include "workcell/files/scene_export.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Pose kStation{{0.5, -0.2, 0.8}, quaternionFromRotationVector({0.0, 0.0, 0.7})};

/// A robot, the frame "station", and a cube.
class FrameCell : public ::testing::Test {
 protected:
  FrameCell() {
    Diagnostics notes;
    Entity arm = EntityLoader(".").load("library:kuka_kr16_2", 0.0, notes).value();
    arm.name = "robot";
    robot = document.execute(AddEntity{std::move(arm)}).value();
    station = document.execute(AddEntity{makeFrame("station", kStation)}).value();
    Entity cube = EntityLoader(".").load("box:0.1,0.1,0.1", 0.0, notes).value();
    cube.name = "cube";
    part = document.execute(AddEntity{std::move(cube)}).value();
  }
  const Entity& get(EntityId id) const { return *document.find(id); }
  std::vector<EffectivePair> pairsOf(EntityId moved) const {
    return effectivePairs(document.snapshotEntities(), document.state().pair_sets, moved, {});
  }
  Document document;
  EntityId robot = 0, station = 0, part = 0;
};

TEST_F(FrameCell, IsMovedRenamedRemovedAndAllOfItUndone) {
  const Pose there = Pose::translation({1, 2, 3});
  ASSERT_TRUE(document.execute(SetPlacement{station, there}).has_value());
  ASSERT_TRUE(document.execute(RenameEntity{station, "pick"}).has_value());
  EXPECT_EQ(get(station).X_WE.p, there.p);
  ASSERT_TRUE(document.execute(RemoveEntity{station}).has_value());
  EXPECT_EQ(document.findByName("pick"), nullptr);
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(document.undo());
  EXPECT_EQ(get(station).name, "station");
  EXPECT_EQ(get(station).X_WE.p, kStation.p);
  ASSERT_TRUE(document.execute(SetProperties{.id = station, .locked = true}).has_value());
  EXPECT_FALSE(document.execute(SetPlacement{station, there}).has_value()) << "locked";
}

TEST_F(FrameCell, GoesWithTheLinkItIsFixedToAndTakesAlongWhatHangsOnIt) {
  const std::string tip = get(robot).jointed().tip_link;
  ASSERT_TRUE(document.execute(Attach{station, robot, tip}).has_value());
  ASSERT_TRUE(document.execute(Attach{part, station, ""}).has_value());
  EXPECT_LT(glm::length(get(station).X_WE.p - kStation.p), 1e-12) << "it keeps its place";
  const Pose X_LF = carrierPose(get(robot), tip).inverse() * get(station).X_WE;
  const Pose X_FP = get(station).X_WE.inverse() * get(part).X_WE;
  std::vector<double> q = get(robot).joints();
  q[0] += 0.4;
  ASSERT_TRUE(document.execute(SetJoints{robot, q}).has_value());
  const Pose X_WF = carrierPose(get(robot), tip) * X_LF;
  EXPECT_LT(glm::length(get(station).X_WE.p - X_WF.p), 1e-12);
  EXPECT_GT(glm::length(get(station).X_WE.p - kStation.p), 0.1);
  EXPECT_LT(glm::length(get(part).X_WE.p - (X_WF * X_FP).p), 1e-12);
  EXPECT_TRUE(isCarriedBy(document.state(), get(part), robot));
  EXPECT_FALSE(isCarriedBy(document.state(), get(robot), part));
  EXPECT_FALSE(document.execute(Attach{robot, part, ""}).has_value()) << "not in a circle";
}

TEST_F(FrameCell, HasNoContactsAndNoWeight) {
  ASSERT_TRUE(document.execute(SetProperties{.id = station, .checked = true}).has_value());
  EXPECT_THAT(pairsOf(station), IsEmpty());
  for (const EffectivePair& pair : pairsOf(part)) EXPECT_NE(pair.other, station);
  ASSERT_TRUE(document.execute(Attach{station, robot, ""}).has_value());
  EXPECT_EQ(carriedLoad(document.state(), get(robot)).mass, 0.0);
  EXPECT_THAT(carriedLoad(document.state(), get(robot)).parts, IsEmpty());
  ASSERT_TRUE(document.execute(SetProperties{.id = part, .mass = 3.0}).has_value());
  ASSERT_TRUE(document.execute(Attach{part, station, ""}).has_value());
  const CarriedLoad load = carriedLoad(document.state(), get(robot));
  EXPECT_NEAR(load.mass, 3.0, 1e-12) << "what hangs on the frame counts";
  EXPECT_THAT(load.starting, IsEmpty());
}

TEST_F(FrameCell, IsSavedReadAndPackedWithWhatItIsFixedTo) {
  ASSERT_TRUE(document.execute(Attach{station, robot, get(robot).jointed().tip_link}).has_value());
  test::TemporaryFolder folder;
  ASSERT_TRUE(saveDocument(document, folder.path() / "cell.hcell").has_value());
  Diagnostics notes;
  auto again = loadDocument(folder.path() / "cell.hcell", notes);
  ASSERT_TRUE(again.has_value()) << again.error().message();
  EXPECT_THAT(notes.warnings, IsEmpty());
  const Entity* read = again->findByName("station");
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->kind(), EntityKind::kFrame);
  EXPECT_EQ(read->attachment.to, "robot");
  EXPECT_EQ(read->attachment.link, get(robot).jointed().tip_link);
  EXPECT_LT(glm::length(read->X_WE.p - kStation.p), 1e-12);
  EXPECT_FALSE(read->mesh() || read->robot());
  const auto packed = packDocument(again->state(), folder.path() / "packed", "cell.hcell", {folder.path()}, notes);
  ASSERT_TRUE(packed.has_value()) << packed.error().message();
}

TEST_F(FrameCell, LeavesExportsOfShapesAlone) {
  const ImportedScene scene = sceneOf(document.state());
  for (const SceneNode& node : scene.nodes) EXPECT_NE(node.name, "station");
}

TEST(FrameSource, HasNoSizes) {
  Diagnostics notes;
  EXPECT_TRUE(isBuiltIn("frame:"));
  const auto refused = EntityLoader(".").load("frame:0.1", 1.0, notes);
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message(), HasSubstr("frame: alone"));
}

}  // namespace
}  // namespace hapticell::workcell
