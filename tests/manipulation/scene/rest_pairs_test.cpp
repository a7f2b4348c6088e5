// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/rest_pairs.h"

#include <gtest/gtest.h>

#include "manipulation/holding/held_entity.h"
#include "tests/manipulation/session/test_cells.h"

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
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(cell(), workcell::PairPolicy({}, rules), {})).empty())
      << "asked once";
}

TEST(RestPairs, OfARowEachTouchesItsNeighboursInTheOrderOfTheDocument) {
  std::vector<Entity> row;
  for (int i = 0; i < 200; ++i)
    row.push_back(solid(static_cast<workcell::EntityId>(i + 1), "box " + std::to_string(i), geometry::makeBox(dvec3(0.1)),
                        Pose::translation({0.1 * i + (i >= 100 ? 0.05 : 0.0), 0, 0})));
  const auto rules = touchingAtRest(*PreparedScene::prepare(row, {}, {}));
  ASSERT_EQ(rules.size(), 198u) << "one gap";
  for (std::size_t k = 0; k < rules.size(); ++k) {
    const std::size_t i = k < 99 ? k : k + 1;
    EXPECT_EQ(rules[k].first, row[i].name);
    EXPECT_EQ(rules[k].second, row[i + 1].name);
  }
}

TEST(RestPairs, ADeepOverlapIsNoTouching) {
  auto deep = cell();
  const workcell::EntityId first = 50;
  deep.push_back(solid(first, "block", geometry::makeBox(dvec3(0.2)), Pose::translation({3.0, 0, 0})));
  deep.push_back(solid(first + 1, "sunk", geometry::makeBox(dvec3(0.2)), Pose::translation({3.15, 0.02, 0})));
  deep.push_back(solid(first + 2, "pressed", geometry::makeBox(dvec3(0.2)), Pose::translation({3.0, -0.1995, 0})));
  deep.push_back(solid(first + 3, "within", geometry::makeBox(dvec3(0.02)), Pose::translation({3.0, 0.01, 0})));
  const auto scene = PreparedScene::prepare(deep, {}, {});
  auto touching = touchingAtRest(*scene);
  const std::size_t all = touching.size();
  const auto found = takeDeepOverlaps(*scene, touching);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].rule.second, "within");
  EXPECT_NEAR(found[0].depth, 0.10, 1e-3);
  EXPECT_EQ(found[1].rule.second, "sunk");
  EXPECT_NEAR(found[1].depth, 0.05, 1e-5);
  EXPECT_EQ(touching.size(), all - 2);
  EXPECT_EQ(touching.back().second, "pressed") << "0.5 mm deep";
}

TEST(RestPairs, WhatCannotMoveOrIsNotCheckedIsNotAskedFor) {
  auto locked = cell();
  locked[0].locked = locked[1].locked = true;
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(locked, {}, {})).empty());
  auto carried = cell();
  carried[1].attachment.to = "table";
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(carried, {}, {})).empty());
  const std::vector<workcell::PairSet> other{{.name = "s", .first = {"hovering"}, .second = {"table"}}};
  EXPECT_TRUE(touchingAtRest(*PreparedScene::prepare(cell(), workcell::PairPolicy(other, {}), {})).empty());
}

/// A tool in the flange of an arm of two links, so long that it reaches the first link too.
std::vector<Entity> armWithATool() {
  auto model = std::make_shared<kinematics::RobotModel>();
  model->name = "arm";
  model->links = {{"base", -1, {}, {}}, {"wrist", 0, {}, {}}, {"flange", 1, {}, {}}};
  kinematics::Joint turn, fixed;
  turn.name = "turn", turn.type = kinematics::JointType::kRevolute, turn.parent_link = 0, turn.child_link = 1;
  turn.axis_J = {0, 0, 1}, turn.lower = -3.0, turn.upper = 3.0, turn.variable = 0;
  turn.X_PJ = Pose::translation({0, 0, 0.2});
  fixed.name = "mount", fixed.type = kinematics::JointType::kFixed, fixed.parent_link = 1, fixed.child_link = 2;
  model->joints = {turn, fixed};
  model->moving = {0};
  kinematics::LinkShape box;
  box.mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)));
  for (const std::size_t link : {0u, 1u}) model->links[link].collisions = {box};
  Entity robot;
  robot.id = 10, robot.name = "arm";
  robot.body = workcell::Robot{{.model = model, .joints = {0.0}, .tip_link = "flange"}};
  Entity tool = solid(11, "tool", geometry::makeBox({0.02, 0.02, 0.5}), Pose::translation({0, 0, 0.2}));
  tool.attachment = {"arm", "flange", Pose::identity()};
  return {robot, tool, solid(12, "wall", geometry::makeBox({0.1, 1.0, 1.0}), Pose::translation({0.11, 0, 0}))};
}

TEST(RestPairs, WhatHangsOnARobotIsMeasuredWithItButNeverAgainstItsOwnLink) {
  const auto pairs = pairsAtRest(*PreparedScene::prepare(armWithATool(), {}, {}), 10, 0.3);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].moved, 11u);
  EXPECT_EQ(pairs[0].other, 10u);
  EXPECT_EQ(pairs[0].other_part, "base") << "the wrist is one body with the flange that the tool hangs on";
  EXPECT_TRUE(pairs[0].contact);
  EXPECT_EQ(pairs[1].moved, 10u);
  EXPECT_NEAR(pairs[1].distance, 0.01, 1e-9);
  EXPECT_EQ(pairs[2].moved, 11u);
  EXPECT_NEAR(pairs[2].distance, 0.05, 1e-9);
}

TEST(RestPairs, AToolThatTouchesAnotherLinkIsAskedAboutAndThenLeftOutEverywhere) {
  const auto cell = armWithATool();
  const auto rules = touchingAtRest(*PreparedScene::prepare(cell, {}, {}));
  ASSERT_EQ(rules.size(), 1u);
  EXPECT_EQ(rules[0].first + "/" + rules[0].first_part, "arm/base");
  EXPECT_EQ(rules[0].second, "tool");
  const auto scene = PreparedScene::prepare(cell, workcell::PairPolicy({}, rules), {});
  EXPECT_TRUE(touchingAtRest(*scene).empty());
  for (const PairState& pair : pairsAtRest(*scene, 10, 0.3)) EXPECT_EQ(pair.other, 12u);
  // What is felt and heard while it is held knows the same pairs.
  const auto held = HeldEntity::take(scene, 10, {}, {}, {});
  ASSERT_TRUE(held) << held.error().message();
  for (const HeldPair& pair : (*held)->pairs()) EXPECT_EQ(pair.other, 12u) << pair.moved_part << pair.other_part;
}

TEST(RestPairs, APairThatARuleLeavesOutIsNotMeasured) {
  const std::vector<workcell::PairRule> rules{{.first = "hovering", .second = "table", .checked = false}};
  const auto pairs = pairsAtRest(*PreparedScene::prepare(cell(), workcell::PairPolicy({}, rules), {}), 3, 0.3);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].other, 2u);
}

}  // namespace
}  // namespace hapticell::manipulation
