// SPDX-License-Identifier: Apache-2.0
#include "manipulation/rest_pairs.h"

#include <gtest/gtest.h>

#include "tests/manipulation/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::solid;
using workcell::Entity;

/// A table, a box that stands on it, one 30 mm above it, one far away.
std::vector<Entity> cell() {
  return {solid(1, "table", geometry::makeBox({1.0, 1.0, 0.1}), Pose::translation({0, 0, -0.05})),
          solid(2, "standing", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 0.03})),
          solid(3, "hovering", geometry::makeBox(dvec3(0.06)), Pose::translation({0.2, 0, 0.06})),
          solid(4, "far", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 5.0}))};
}

TEST(RestPairs, DistancesAreThoseOfTheBoxesNearestFirstAndFarOnesLeftOut) {
  const auto scene = PreparedScene::prepare(cell(), {}, {});
  const auto pairs = pairsAtRest(*scene, 3, 0.3);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].other, 1u);
  EXPECT_NEAR(pairs[0].distance, 0.03, 1e-9);
  EXPECT_EQ(pairs[1].other, 2u);
  EXPECT_NEAR(pairs[1].distance, 0.14, 1e-9);
  EXPECT_FALSE(pairs[0].contact || pairs[0].near_miss);
  const auto standing = pairsAtRest(*scene, 2, 0.3);
  ASSERT_FALSE(standing.empty());
  EXPECT_TRUE(standing[0].contact);
  EXPECT_TRUE(pairsAtRest(*scene, 99, 1.0).empty());
}

TEST(RestPairs, WhatTouchesIsTheStandingBoxAndNothingElse) {
  const auto rules = touchingAtRest(*PreparedScene::prepare(cell(), {}, {}));
  ASSERT_EQ(rules.size(), 1u);
  EXPECT_EQ(rules[0].first, "table");
  EXPECT_EQ(rules[0].second, "standing");
  EXPECT_FALSE(rules[0].checked);
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(cell(), {{}, rules}, {})).empty()) << "asked once";
}

TEST(RestPairs, WhatCannotMoveOrIsNotCheckedIsNotAskedFor) {
  auto locked = cell();
  locked[0].locked = locked[1].locked = true;
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(locked, {}, {})).empty());
  auto carried = cell();
  carried[1].attachment.to = "table";
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(carried, {}, {})).empty());
  const std::vector<workcell::PairSet> other{{.name = "s", .first = {"hovering"}, .second = {"table"}}};
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(cell(), other, {})).empty());
}

TEST(RestPairs, APairThatARuleLeavesOutIsNotMeasured) {
  const std::vector<workcell::PairRule> rules{{.first = "hovering", .second = "table", .checked = false}};
  const auto pairs = pairsAtRest(*PreparedScene::prepare(cell(), {{}, rules}, {}), 3, 0.3);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].other, 2u);
}

}  // namespace
}  // namespace hapticell::manipulation
