// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/own_pairs.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "tests/kinematics/model/test_robots.h"

namespace hapticell::manipulation {
namespace {

using IndexPairs = std::set<std::pair<std::size_t, std::size_t>>;

IndexPairs pairsOf(const kinematics::RobotModel& model, const std::vector<OwnPart>& parts) {
  IndexPairs found;
  for (const OwnPair& pair : ownPairs(model, parts)) {
    EXPECT_LT(pair.first, pair.second);
    EXPECT_TRUE(found.insert({pair.first, pair.second}).second) << "each once";
  }
  return found;
}

TEST(OwnPairs, LeaveOutWhatOneJointConnectsAndWhatIsRigid) {
  const kinematics::RobotModel model = kinematics::test::kr120();
  std::vector<OwnPart> parts;
  for (std::size_t k = 0; k < model.links.size(); ++k) parts.push_back({static_cast<int>(k), false});
  const std::vector<int> body = kinematics::rigidBodies(model);
  IndexPairs wanted;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      bool neighbours = body[i] == body[k];
      for (const kinematics::Joint& joint : model.joints) {
        const int a = body[static_cast<std::size_t>(joint.parent_link)], b = body[static_cast<std::size_t>(joint.child_link)];
        neighbours = neighbours || (a == body[i] && b == body[k]) || (a == body[k] && b == body[i]);
      }
      if (!neighbours) wanted.insert({i, k});
    }
  }
  EXPECT_FALSE(wanted.empty());
  EXPECT_EQ(pairsOf(model, parts), wanted);
}

TEST(OwnPairs, WhatIsCarriedMeetsTheNextLinkButNotWhatIsCarriedBesideIt) {
  kinematics::RobotModel model = kinematics::test::kr120();
  const int tip = model.defaultTip();
  int before = tip;
  const std::vector<int> body = kinematics::rigidBodies(model);
  for (const kinematics::Joint& joint : model.joints)
    if (body[static_cast<std::size_t>(joint.child_link)] == body[static_cast<std::size_t>(tip)] &&
        body[static_cast<std::size_t>(joint.parent_link)] != body[static_cast<std::size_t>(tip)])
      before = joint.parent_link;
  ASSERT_NE(before, tip);
  // The last link, the one before it, and two parts in the gripper.
  const std::vector<OwnPart> parts{{tip, false}, {before, false}, {tip, true}, {tip, true}};
  EXPECT_EQ(pairsOf(model, parts), (IndexPairs{{1, 2}, {1, 3}}));
  const std::vector<OwnPart> far{{0, false}, {tip, false}};
  EXPECT_EQ(pairsOf(model, far), (IndexPairs{{0, 1}}));
  model.disabled_pairs.push_back({tip, 0, "Never"});
  EXPECT_TRUE(pairsOf(model, far).empty()) << "by an SRDF, in either order";
  EXPECT_EQ(pairsOf(model, {{0, false}, {tip, true}}), (IndexPairs{{0, 1}})) << "that says nothing of what is carried";
}

}  // namespace
}  // namespace hapticell::manipulation
