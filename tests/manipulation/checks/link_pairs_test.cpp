// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/link_pairs.h"

#include <gtest/gtest.h>

#include <numbers>

namespace hapticell::manipulation {
namespace {

using kinematics::RobotModel;

std::shared_ptr<const geometry::TriangleMesh> smallCube() {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({(i & 1) ? 0.05 : -0.05, (i & 2) ? 0.05 : -0.05, (i & 4) ? 0.05 : -0.05});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

/// Cubes A at the origin, B 0.3 m away on a turning arm, and C on an arm of the same length that turns about B: C is
/// 0.6 |sin(q2 / 2)| from A.
RobotModel foldingArm(double lower, double upper) {
  RobotModel model;
  const double offsets[] = {0.0, 0.3, -0.3};
  for (int i = 0; i < 3; ++i) {
    kinematics::Link link;
    link.name = std::string(1, static_cast<char>('A' + i));
    link.parent_joint = i - 1;
    link.collisions.push_back({smallCube(), Pose::translation({offsets[i], 0.0, 0.0}), {}, "box"});
    model.links.push_back(link);
    if (i == 0) continue;
    kinematics::Joint joint;
    joint.name = "j" + std::to_string(i);
    joint.type = kinematics::JointType::kRevolute;
    joint.parent_link = i - 1;
    joint.child_link = i;
    joint.X_PJ = Pose::translation({i == 2 ? 0.3 : 0.0, 0.0, 0.0});
    joint.lower = i == 1 ? -std::numbers::pi : lower;
    joint.upper = i == 1 ? std::numbers::pi : upper;
    joint.variable = i - 1;
    model.moving.push_back(i - 1);
    model.joints.push_back(joint);
  }
  return model;
}

std::string reasonOf(const RobotModel& model, int samples) {
  for (const auto& pair : pairsWithoutCheck(model, linkPairUse(model, {samples, 3}), samples))
    if (pair.first == 0 && pair.second == 2) return pair.reason;
  return "";
}

TEST(LinkPairs, ShareOfContactsIsThatOfTheGeometry) {
  const RobotModel model = foldingArm(-std::numbers::pi, std::numbers::pi);
  const auto use = linkPairUse(model, {4000, 3});
  ASSERT_EQ(use.size(), 3u);
  EXPECT_TRUE(use[0].adjacent);   // A and B.
  EXPECT_FALSE(use[1].adjacent);  // A and C.
  EXPECT_TRUE(use[1].at_rest);
  EXPECT_EQ(use[0].contacts, 0);
  // The cubes touch if their inner spheres do (4 asin(1/6) of the circle) and not if their outer ones do not
  // (4 asin(sqrt(3)/6)): 10.7 % to 18.6 %; four standard deviations of 4000 samples are 2.5 %.
  EXPECT_GT(use[1].contacts, 0.082 * 4000);
  EXPECT_LT(use[1].contacts, 0.211 * 4000);
}

TEST(LinkPairs, ReasonsAreThoseOfMoveIt) {
  EXPECT_EQ(reasonOf(foldingArm(2.0, 3.0), 500), "Never");
  EXPECT_EQ(reasonOf(foldingArm(-0.1, 0.1), 500), "Default");
  RobotModel away = foldingArm(-std::numbers::pi, std::numbers::pi);
  away.home = {0.0, 3.0};
  EXPECT_EQ(reasonOf(away, 500), "");  // It can touch, so it is checked.
  RobotModel close = foldingArm(-0.1, 1.0);
  close.joints[1].upper = 0.1;
  close.home = {0.0, 0.05};
  const auto use = linkPairUse(close, {500, 3});
  EXPECT_EQ(use[1].contacts, 500);
  auto not_at_rest = use;
  not_at_rest[1].at_rest = false;
  EXPECT_EQ(pairsWithoutCheck(close, not_at_rest, 500)[1].reason, "Always");
}

TEST(LinkPairs, WhatTheModelDisablesStays) {
  RobotModel model = foldingArm(-std::numbers::pi, std::numbers::pi);
  model.disabled_pairs = {{2, 0, "User"}};
  const auto pairs = pairsWithoutCheck(model, linkPairUse(model, {100, 3}), 100);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].reason, "User");
  EXPECT_EQ(linkPairUse(model, {100, 3})[1].contacts, linkPairUse(model, {100, 3})[1].contacts);
}

}  // namespace
}  // namespace hapticell::manipulation
