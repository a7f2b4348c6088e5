// SPDX-License-Identifier: Apache-2.0
#include "access/removal_way.h"

#include "access/planned_way.h"
#include "access/removal_check.h"
#include "tests/access/access_cell.h"

namespace hapticell::access {
namespace {

/// A block in a channel that turns: out along x is closed by a wall, so it goes along x and then along y.
AccessCell bentChannel() {
  AccessCell cell;
  cell.box("block", {0.05, 0.05, 0.05}, {0.0, 0.0, 0.0});
  cell.box("floor", {0.5, 0.5, 0.02}, {0.15, 0.1, -0.036}, true);
  cell.box("ceiling", {0.5, 0.5, 0.02}, {0.15, 0.1, 0.036}, true);
  cell.box("wall behind", {0.02, 0.1, 0.05}, {-0.04, 0.0, 0.0}, true);
  cell.box("wall right", {0.3, 0.02, 0.05}, {0.1, -0.04, 0.0}, true);
  cell.box("wall left", {0.12, 0.02, 0.05}, {0.02, 0.04, 0.0}, true);
  cell.box("wall ahead", {0.02, 0.3, 0.05}, {0.2, 0.1, 0.0}, true);
  return cell;
}

TEST(RemovalWay, GoesAroundACorner) {
  const RemovalScene scene = bentChannel().removal("block");
  const auto way = bentWay(scene, 0, 0);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->kind, RemovalWay::Kind::kBent);
  EXPECT_GE(way->X_WE.size(), 3u);
  const auto motion = trajectoryOf(scene, 0, *way, 0.1);
  EXPECT_TRUE(removalPromises(scene, 0, 0, motion).areKept());
  EXPECT_NEAR(motion.duration(), way->length() / 0.1, 1e-9);
  EXPECT_EQ(motion.moved, "self_origin");
}

TEST(RemovalWay, ADeadEndHasNone) {
  AccessCell cell = bentChannel();
  cell.box("wall end", {0.4, 0.02, 0.05}, {0.1, 0.2, 0.0}, true);
  cell.box("wall left end", {0.02, 0.3, 0.05}, {-0.02, 0.12, 0.0}, true);
  EXPECT_FALSE(bentWay(cell.removal("block"), 0, 0));
}

TEST(RemovalWay, ThePromisesFindAWayThroughAWall) {
  const RemovalScene scene = boxedIn(0.001, true).removal("block");
  const auto through = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.5);
  EXPECT_FALSE(removalPromises(scene, 0, 0, trajectoryOf(scene, 0, through, 0.1)).areKept());
  // With the lid gone it is kept.
  EXPECT_TRUE(removalPromises(scene, 0, UnitSet{2}, trajectoryOf(scene, 0, through, 0.1)).areKept());
  // Too short: still in the box.
  const auto half = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.02);
  EXPECT_FALSE(removalPromises(scene, 0, UnitSet{2}, trajectoryOf(scene, 0, half, 0.1)).areKept());
}

TEST(RemovalWay, OnlyAWayThatKeepsItsPromisesIsKept) {
  const RemovalScene scene = boxedIn(0.001, true).removal("block");
  const auto up = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.5);
  const auto refused = keptMotion(scene, 0, 0, up, 0.1);
  ASSERT_FALSE(refused.has_value()) << "the lid is in the way";
  EXPECT_NE(refused.error().message().find("depth"), std::string::npos) << refused.error().message();
  EXPECT_NE(refused.error().message().find("Nothing was written."), std::string::npos);
  EXPECT_EQ(refused.error().message().find("--"), std::string::npos) << "a window has no options";
  const auto kept = keptMotion(scene, 0, UnitSet{2}, up, 0.1);
  ASSERT_TRUE(kept.has_value()) << kept.error().message();
  EXPECT_EQ(kept->entity, "block");
  EXPECT_NEAR(kept->duration(), up.length() / 0.1, 1e-6);
  const auto half = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, 0.02);
  EXPECT_FALSE(keptMotion(scene, 0, UnitSet{2}, half, 0.1).has_value()) << "still in the box";
}

TEST(RemovalWay, ClearancesAreThoseOfTheGaps) {
  const RemovalScene scene = boxedIn(0.003, false).removal("block");
  const auto way = straightAsWay(scene, 0, {0.0, 0.0, 1.0}, scene.wayOut(0, {0.0, 0.0, 1.0}));
  const auto found = clearances(scene, 0, 0, way);
  int walls = 0;
  for (const NeighbourClearance& one : found) {
    if (one.name == "floor") {
      EXPECT_TRUE(one.touches_at_rest);
      EXPECT_FALSE(std::isfinite(one.least_m));  // It leaves the floor at once.
    } else {
      EXPECT_NEAR(one.least_m, 0.003, 1e-9) << one.name;
      EXPECT_FALSE(one.touches_at_rest);
      ++walls;
    }
  }
  EXPECT_EQ(walls, 4);
  // Without a gap it slides along the walls.
  const RemovalScene tight = boxedIn(0.0, false).removal("block");
  for (const NeighbourClearance& one : clearances(tight, 0, 0, straightAsWay(tight, 0, {0.0, 0.0, 1.0}, 0.1))) {
    if (one.name == "floor") continue;
    EXPECT_EQ(one.least_m, 0.0) << one.name;
    EXPECT_GT(one.slides_m, 0.08) << one.name;
  }
}

TEST(RemovalWay, AShownWayIsCheckedLikeAFoundOne) {
  const RemovalScene scene = boxedIn(0.003, false).removal("block");
  trajectory::Trajectory shown;
  shown.addFrame({0.0, {}});
  shown.addFrame({1.0, Pose::translation({0.0, 0.0, 0.12})});
  shown.addFrame({2.0, Pose::translation({0.3, 0.0, 0.12})});
  const auto way = checkedWay(scene, 0, 0, shown);
  ASSERT_TRUE(way) << way.error().message();
  EXPECT_EQ(way->kind, RemovalWay::Kind::kShown);
  trajectory::Trajectory through;
  through.addFrame({0.0, {}});
  through.addFrame({1.0, Pose::translation({0.3, 0.0, 0.0})});
  const auto met = checkedWay(scene, 0, 0, through);
  ASSERT_FALSE(met);
  EXPECT_NE(met.error().message().find("wall right"), std::string::npos) << met.error().message();
  trajectory::Trajectory elsewhere;
  elsewhere.addFrame({0.0, Pose::translation({0.0, 0.0, 0.5})});
  elsewhere.addFrame({1.0, Pose::translation({0.0, 0.0, 0.9})});
  EXPECT_FALSE(checkedWay(scene, 0, 0, elsewhere));
}

TEST(RemovalWay, UnitMotionNamesWhatStopsIt) {
  const RemovalScene scene = boxedIn(0.003, false).removal("block");
  UnitMotion motion(scene, 0, 0);
  const double share = motion.advance({}, Pose::translation({0.1, 0.0, 0.0}));
  // The thinned block has 0.1 mm more.
  EXPECT_NEAR(share, 0.031, 1e-4);
  ASSERT_TRUE(motion.stoppedBy());
  EXPECT_EQ(scene.units()[*motion.stoppedBy()].name, "wall right");
  EXPECT_FALSE(motion.collidesAt(Pose::translation({0.003, 0.0, 0.0})));
  EXPECT_TRUE(motion.collidesAt(Pose::translation({0.004, 0.0, 0.0})));
}

/// A plate in a chamber whose opening at the top is narrower than the plate is long: it has to be turned.
AccessCell turningChamber(double opening) {
  AccessCell cell;
  const double beside = 0.5 * (0.30 - opening);
  cell.box("plate", {0.20, 0.02, 0.06}, {0.0, 0.0, 0.0});
  cell.box("front", {0.34, 0.02, 0.30}, {0.0, -0.12, 0.05}, true);
  cell.box("back", {0.34, 0.02, 0.30}, {0.0, 0.12, 0.05}, true);
  cell.box("bottom", {0.34, 0.26, 0.02}, {0.0, 0.0, -0.11}, true);
  cell.box("left", {0.02, 0.26, 0.30}, {-0.16, 0.0, 0.05}, true);
  cell.box("right", {0.02, 0.26, 0.30}, {0.16, 0.0, 0.05}, true);
  cell.box("top left", {beside, 0.26, 0.02}, {-0.5 * (opening + beside), 0.0, 0.19}, true);
  cell.box("top right", {beside, 0.26, 0.02}, {0.5 * (opening + beside), 0.0, 0.19}, true);
  return cell;
}

TEST(PlannedWay, TurnsAPlateThroughAnOpeningThatIsNarrowerThanItIsLong) {
  const std::atomic<bool> cancel{false};
  const RemovalScene scene = turningChamber(0.12).removal("plate");
  EXPECT_FALSE(bentWay(scene, 0, 0));
  const auto way = plannedWay(scene, 0, 0, cancel);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->kind, RemovalWay::Kind::kPlanned);
  EXPECT_TRUE(removalPromises(scene, 0, 0, trajectoryOf(scene, 0, *way, 0.1)).areKept());
  double turned = 0.0;
  for (const Pose& X_WE : way->X_WE) turned = std::max(turned, glm::length(rotationVector(X_WE.q)));
  EXPECT_GT(turned, 0.5);
}

}  // namespace
}  // namespace hapticell::access
