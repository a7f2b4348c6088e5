// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/pair_policy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace hapticell::workcell {
namespace {

std::vector<Entity> named(const std::vector<std::string>& names) {
  std::vector<Entity> entities;
  for (const std::string& name : names) {
    Entity entity;
    entity.id = entities.size() + 1;
    entity.name = name;
    entities.push_back(entity);
  }
  return entities;
}

TEST(PairPolicy, WithoutSetsEverythingIsCheckedAgainstTheMovedOne) {
  const auto entities = named({"part", "table", "robot"});
  const auto pairs = effectivePairs(entities, {}, 1, {0.002, 0.03});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].moved, 1u);
  EXPECT_EQ(pairs[0].other, 2u);
  EXPECT_EQ(pairs[1].other, 3u);
  EXPECT_EQ(pairs[0].safety_distance, 0.002);
  EXPECT_EQ(pairs[1].near_miss, 0.03);
}

TEST(PairPolicy, WithSetsOnlyTheirPairsCountEitherWayRound) {
  const auto entities = named({"part", "table", "robot", "fence"});
  const std::vector<PairSet> sets = {{.name = "a", .first = {"part"}, .second = {"table"}, .safety_distance = 0.004},
                                     {.name = "b", .first = {"robot"}, .second = {"part", "fence"}, .near_miss = 0.05}};
  const auto of_part = effectivePairs(entities, sets, 1);
  ASSERT_EQ(of_part.size(), 2u);
  EXPECT_EQ(of_part[0].other, 2u);
  EXPECT_EQ(of_part[0].safety_distance, 0.004);
  EXPECT_EQ(of_part[1].other, 3u);
  EXPECT_EQ(of_part[1].near_miss, 0.05);
  EXPECT_EQ(effectivePairs(entities, sets, 2).size(), 1u);
  EXPECT_EQ(effectivePairs(entities, sets, 4)[0].other, 3u);
}

TEST(PairPolicy, AnAssemblyIsCheckedAgainstWhatDoesNotGoAlong) {
  auto entities = named({"bolt", "clamp", "rig", "plate", "table"});
  entities[1].body = entities[2].body = Assembly{};
  entities[0].parent = "clamp";  // Before what it stands below.
  entities[1].parent = entities[3].parent = "rig";
  const auto of_rig = effectivePairs(entities, {}, 3);
  ASSERT_EQ(of_rig.size(), 1u);
  EXPECT_EQ(of_rig[0].other, 5u);
  const auto of_clamp = effectivePairs(entities, {}, 2);
  ASSERT_EQ(of_clamp.size(), 2u);
  EXPECT_EQ(of_clamp[0].other, 4u);
  const auto of_bolt = effectivePairs(entities, {}, 1);
  ASSERT_EQ(of_bolt.size(), 2u) << "no assembly has a shape";
  EXPECT_EQ(of_bolt[0].other, 4u);
  EXPECT_EQ(effectivePairs(entities, std::vector<PairSet>{{.name = "all"}}, 3).size(), 1u);
}

TEST(PairPolicy, AnEmptySideMeansEverything) {
  const auto entities = named({"part", "table", "robot"});
  const std::vector<PairSet> sets = {{.name = "a", .first = {"part"}}};
  EXPECT_EQ(effectivePairs(entities, sets, 1).size(), 2u);
  EXPECT_EQ(effectivePairs(entities, sets, 2).size(), 1u);
}

TEST(PairPolicy, SeveralSetsForOnePairGiveTheLargerDistances) {
  const auto entities = named({"part", "table"});
  const std::vector<PairSet> sets = {
      {.name = "a", .first = {"part"}, .safety_distance = 0.004, .near_miss = 0.02, .on_contact = OnContact::kStop},
      {.name = "b", .second = {"table"}, .safety_distance = 0.001, .near_miss = 0.05}};
  const auto pairs = effectivePairs(entities, sets, 1);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].safety_distance, 0.004);
  EXPECT_EQ(pairs[0].near_miss, 0.05);
  EXPECT_EQ(pairs[0].on_contact, OnContact::kStop);
}

TEST(PairPolicy, LeavesOutWhatIsNotChecked) {
  auto entities = named({"part", "table", "robot"});
  entities[1].checked = false;
  EXPECT_EQ(effectivePairs(entities, {}, 1).size(), 1u);
  EXPECT_TRUE(effectivePairs(entities, {}, 2).empty());
  EXPECT_TRUE(effectivePairs(entities, {}, 7).empty());
  const std::vector<PairSet> off = {{.name = "a", .enabled = false}};
  EXPECT_TRUE(effectivePairs(entities, off, 1).empty());
}

TEST(PairPolicy, ARuleIsFoundEitherWayRoundAndTheOneThatNamesLinksCountsMore) {
  const std::vector<PairRule> rules = {
      {.first = "robot", .second = "table", .checked = false},
      {.first = "table", .second = "robot", .second_part = "flange", .on_contact = OnContact::kStop}};
  const PairRule* whole = ruleFor(rules, {"table", ""}, {"robot", "base"});
  ASSERT_NE(whole, nullptr);
  EXPECT_FALSE(whole->checked);
  const PairRule* link = ruleFor(rules, {"robot", "flange"}, {"table", ""});
  ASSERT_NE(link, nullptr);
  EXPECT_TRUE(link->checked);
  EXPECT_EQ(link->on_contact, OnContact::kStop);
  EXPECT_EQ(ruleFor(rules, {"robot", "base"}, {"fence", ""}), nullptr);
  EXPECT_TRUE(
      samePair({.first = "a", .first_part = "x", .second = "b"}, {.first = "b", .second = "a", .second_part = "x"}));
  EXPECT_FALSE(samePair({.first = "a", .first_part = "x", .second = "b"}, {.first = "b", .second = "a"}));
}

TEST(PairPolicy, WhatIsAttachedIsOneBodyWithTheLinkItIsAttachedTo) {
  auto entities = named({"robot", "gripper", "part", "table"});
  auto model = std::make_shared<kinematics::RobotModel>();
  model->links = {{"base", -1, {}, {}}, {"wrist", 0, {}, {}}, {"flange", 1, {}, {}}};
  kinematics::Joint turn, mount;
  turn.type = kinematics::JointType::kRevolute, turn.parent_link = 0, turn.child_link = 1, turn.variable = 0;
  mount.type = kinematics::JointType::kFixed, mount.parent_link = 1, mount.child_link = 2;
  model->joints = {turn, mount};
  model->moving = {0};
  Entity &robot = entities[0], &gripper = entities[1], &part = entities[2], &table = entities[3];
  robot.body = Robot{{.model = model}};
  gripper.attachment = {"robot", "flange", {}};
  part.attachment = {"gripper", "", {}};
  robot.attachment = {"table", "", {}};
  EXPECT_EQ(rigidBodyOf(entities, part, -1), (RigidBody{robot.id, 1})) << "by the gripper on the flange, of the wrist";
  EXPECT_EQ(rigidBodyOf(entities, gripper, -1), rigidBodyOf(entities, robot, 2));
  EXPECT_EQ(rigidBodyOf(entities, robot, 0), rigidBodyOf(entities, table, -1)) << "the base stands on the table";
  EXPECT_NE(rigidBodyOf(entities, robot, 1), rigidBodyOf(entities, table, -1));
  table.attachment = {"part", "", {}};  // A circle, as a broken file may have it, ends too.
  EXPECT_EQ(rigidBodyOf(entities, table, -1), (RigidBody{robot.id, 1}));
  gripper.attachment.to = "nobody";
  EXPECT_EQ(rigidBodyOf(entities, part, -1), (RigidBody{gripper.id, 0}));
}

TEST(PairFinder, SaysOfTwoWhatTheWholeListSays) {
  auto entities = named({"cell", "group", "a", "b", "c", "d", "frame"});
  entities[0].body = entities[1].body = Assembly{};
  entities[1].parent = "cell";
  entities[2].parent = entities[3].parent = "group";
  entities[4].checked = false;
  entities[6].body = CellFrame{};
  const std::vector<PairSet> some = {{.name = "s", .first = {"group"}, .second = {"d"}, .safety_distance = 0.004},
                                     {.name = "t", .first = {"a"}, .second = {}, .near_miss = 0.05}};
  for (const auto& sets : {std::vector<PairSet>{}, some}) {
    const PairFinder finder(entities, sets, {0.002, 0.03});
    for (const Entity& moved : entities) {
      const auto pairs = effectivePairs(entities, sets, moved.id, {0.002, 0.03});
      for (const Entity& other : entities) {
        const auto at =
            std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.other == other.id; });
        const auto found = finder.pairOf(moved, other);
        ASSERT_EQ(found.has_value(), at != pairs.end()) << moved.name << " " << other.name;
        if (!found) continue;
        EXPECT_EQ(found->safety_distance, at->safety_distance);
        EXPECT_EQ(found->near_miss, at->near_miss);
        EXPECT_EQ(found->on_contact, at->on_contact);
      }
    }
  }
  EXPECT_EQ(effectivePairs(entities, {}, 3, {}, OnContact::kPass).front().on_contact, OnContact::kPass);
}

}  // namespace
}  // namespace hapticell::workcell
