// SPDX-License-Identifier: Apache-2.0
#include "access/straight_removal.h"

#include "access/ordered.h"
#include "access/removal_directions.h"
#include "access/sweep_limits.h"
#include "access/thinned_mesh.h"
#include "collision/queries/proximity_query.h"
#include "tests/access/access_cell.h"

#include <random>

namespace hapticell::access {
namespace {

/// What the part meets along a way, by small steps and single queries of the thinned part.
UnitSet metBySteps(const RemovalScene& scene, std::size_t unit, const dvec3& way_W, int steps) {
  UnitSet met = 0;
  for (std::size_t other = 0; other < scene.units().size(); ++other) {
    if (other == unit) continue;
    for (int i = 0; i <= steps; ++i) {
      const auto& a = scene.units()[unit].parts[0];
      const auto& b = scene.units()[other].parts[0];
      Pose X_WA = a.X_WP;
      X_WA.p += (static_cast<double>(i) / steps) * way_W;
      if (collision::distance(a.thin, X_WA, b.part->mesh.collider, b.X_WP).colliding) met |= UnitSet{1} << other;
    }
  }
  return met;
}

TEST(ThinnedMesh, MovesEachFaceOfABoxInwards) {
  const auto box = geometry::makeBox({0.1, 0.2, 0.3});
  const auto size = thinned(box, 1e-3).bounds().size();
  EXPECT_NEAR(size.x, 0.098, 1e-8);
  EXPECT_NEAR(size.y, 0.198, 1e-8);
  EXPECT_NEAR(size.z, 0.298, 1e-8);
  // A cylinder's side moves by the same; a thin sheet by a tenth of its thickness.
  EXPECT_NEAR(thinned(geometry::makeCylinder(0.05, 0.1, 64), 1e-3).bounds().max.x, 0.049, 5e-6);
  EXPECT_NEAR(thinned(geometry::makeBox({0.1, 0.1, 1e-3}), 1e-3).bounds().size().z, 0.8e-3, 1e-8);
}

TEST(AreApart, OnlyWithAGapAlongAnAxis) {
  const geometry::Bounds a{dvec3(0.0), dvec3(1.0)};
  EXPECT_TRUE(areApart(a, {{1.5, 0.0, 0.0}, {2.0, 1.0, 1.0}}));
  EXPECT_FALSE(areApart(a, {{1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}}));
  EXPECT_FALSE(areApart(a, {{0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}}));
}

TEST(Ordered, KeepsEachItemWhole) {
  std::vector<dvec3> items;
  for (int i = 0; i < 30; ++i) items.emplace_back(i + 1, 7 * i % 5, 0.0);
  const auto sorted = ordered(items, [](const dvec3& item) { return item.y; });
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    EXPECT_LE(sorted[i - 1].y, sorted[i].y);
    if (sorted[i - 1].y == sorted[i].y) {
      EXPECT_LT(sorted[i - 1].x, sorted[i].x);
    }
  }
  EXPECT_EQ(sorted[0].x, 1.0);
}

TEST(StraightRemoval, ATouchingBlockLeavesThroughTheOpenSideOnly) {
  // No gap at all: the block touches floor and walls.
  const AccessCell cell = boxedIn(0.0, false);
  const RemovalScene scene = cell.removal("block");
  const auto ways = straightWays(scene, 0);
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_TRUE(ways[0].isFree());
  EXPECT_NEAR(ways[0].direction_W.z, 1.0, 1e-9);
  EXPECT_TRUE(overlappingAtRest(scene, 0).empty());
}

TEST(StraightRemoval, TheLidIsWhatMustGo) {
  const RemovalScene scene = boxedIn(0.001, true).removal("block");
  const auto ways = straightWays(scene, 0);
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_TRUE(ways[0].fixed.empty());
  EXPECT_EQ(ways[0].blockers, UnitSet{1} << 1);
  EXPECT_EQ(scene.units()[1].name, "lid");
}

TEST(StraightRemoval, OverlapBeyondTheToleranceBlocksEverywhere) {
  AccessCell cell;
  cell.box("peg", {0.02, 0.02, 0.1}, {0.0, 0.0, 0.0});
  cell.box("plate", {0.2, 0.2, 0.02}, {0.0, 0.0, 0.0});
  const RemovalScene scene = cell.removal("peg");
  EXPECT_EQ(overlappingAtRest(scene, 0), std::vector<std::size_t>{1});
  for (const StraightWay& way : straightWays(scene, 0)) EXPECT_EQ(way.blockers, UnitSet{2});
}

TEST(StraightRemoval, FindsTheAxisOfASlantingBore) {
  AccessCell cell;
  const dquat turn = quaternionFromRotationVector({0.37, 0.21, 0.0});
  workcell::Entity& pin = cell.add("pin", geometry::makeCylinder(0.0098, 0.2, 48), dvec3(0.0));
  pin.X_WE.q = turn;
  cell.add("bush", geometry::makePipe(0.03, 0.01, 0.1, 48), dvec3(0.0)).X_WE.q = turn;
  const RemovalScene scene = cell.removal("pin");
  const auto ways = straightWays(scene, 0);
  ASSERT_FALSE(ways.empty());
  EXPECT_TRUE(ways[0].isFree());
  EXPECT_GT(std::abs(glm::dot(ways[0].direction_W, turn * dvec3(0.0, 0.0, 1.0))), 0.9999);
}

TEST(StraightRemoval, AgreesWithSmallSteps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.25, 0.25), size(0.02, 0.12);
  std::size_t blocked = 0;
  for (int round = 0; round < 4; ++round) {
    AccessCell cell;
    cell.box("part", {0.05, 0.05, 0.05}, dvec3(0.0));
    for (int i = 0; i < 8; ++i)
      cell.box("other " + std::to_string(i), {size(random), size(random), size(random)},
               {place(random), place(random), place(random)});
    const RemovalScene scene = cell.removal("part");
    for (const dvec3& direction : removalDirections(scene, 0)) {
      const double length = scene.wayOut(0, direction);
      const StraightWay way = straightWay(scene, 0, direction, length);
      const UnitSet met = metBySteps(scene, 0, length * direction, 200);
      EXPECT_EQ(met & ~way.blockers, 0u) << "steps meet what the sweep does not, round " << round;
      // The sweep also finds grazes between two steps; those are rare.
      blocked += way.blockers != met ? 1 : 0;
    }
  }
  EXPECT_LT(blocked, 8u);
}

}  // namespace
}  // namespace hapticell::access
