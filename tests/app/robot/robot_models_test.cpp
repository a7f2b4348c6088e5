// SPDX-License-Identifier: Apache-2.0
// The models of app/robot, without a display.
#include <gtest/gtest.h>

#include <cmath>

#include "app/robot/configuration_model.h"
#include "app/robot/robot_facts.h"
#include "app/controls/robot_ghosts.h"
#include "geometry/shapes/shapes.h"
#include "kinematics/closures/arm_builder.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

workcell::Entity libraryRobot(const std::string& name) {
  Diagnostics diagnostics;
  auto entity = workcell::EntityLoader({}).load("library:" + name, 0.0, diagnostics);
  EXPECT_TRUE(entity.has_value()) << name;
  workcell::Entity robot = entity ? std::move(*entity) : workcell::Entity{};
  if (robot.robot()) robot.setJoints(kinematics::restPositions(*robot.robot()));
  return robot;
}

TEST(RobotFacts, FlangeReachIsTheStretchedArm) {
  const workcell::Entity robot = libraryRobot("kuka_kr16_2");
  ASSERT_TRUE(robot.robot());
  // a1, then upper arm, forearm with its offset, and the hand, all in one line: no pose reaches further.
  const double stretched = 0.260 + 0.680 + std::hypot(0.670, 0.035) + 0.158;
  const double reach = flangeReach(*robot.robot());
  EXPECT_LE(reach, stretched + 1e-9);
  EXPECT_GT(reach, stretched - 2e-3) << "with the wrist a little bent by the forearm's offset";
}

TEST(RobotFacts, SearchFindsWordsInAnyOrderAndIgnoresDashes) {
  EXPECT_TRUE(matchesSearch("KUKA KR16-2 6-axis 16 kg", "kr 16"));
  EXPECT_TRUE(matchesSearch("KUKA KR16-2 6-axis 16 kg", "16kg kuka"));
  EXPECT_TRUE(matchesSearch("Stäubli TX2-60", "stäubli"));
  EXPECT_FALSE(matchesSearch("KUKA KR16-2", "abb"));
  EXPECT_TRUE(matchesSearch("anything", ""));
}

TEST(RobotGhosts, WhatHangsOnTheFlangeGoesWithIt) {
  workcell::Document document;
  const auto robot = document.execute(workcell::AddEntity{libraryRobot("kuka_kr16_2")});
  ASSERT_TRUE(robot.has_value());
  workcell::Entity part;
  part.name = "part";
  part.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)))};
  part.X_WE = Pose::translation({1, 0, 1});
  const auto id = document.execute(workcell::AddEntity{part});
  ASSERT_TRUE(document.execute(workcell::Attach{*id, *robot, {}}).has_value());
  std::vector<double> joints = document.find(*robot)->joints();
  joints[0] += 0.5;
  const auto ghosts = robotGhosts(document.state(), *robot, joints, true);
  ASSERT_EQ(ghosts.size(), 2u);
  EXPECT_EQ(ghosts[1].entity, *id);
  EXPECT_TRUE(ghosts[1].touches);
  // The document's own command is the second way to the same pose.
  ASSERT_TRUE(document.execute(workcell::SetJoints{*robot, joints}).has_value());
  EXPECT_LT(glm::length(ghosts[1].X_WE.p - document.find(*id)->X_WE.p), 1e-12);
  EXPECT_TRUE(robotGhosts(document.state(), *robot, {1.0}).empty()) << "another number of joints";
}

TEST(RobotGhosts, HalfWayIsHalfOfEachJoint) {
  EXPECT_EQ(jointsBetween({0, 1}, {2, 3}, 0.5), (std::vector<double>{1, 2}));
  EXPECT_EQ(jointsBetween({0, 1}, {2, 3}, 1.0), (std::vector<double>{2, 3}));
}

TEST(ConfigurationModel, WritesAbbsFlagsShort) {
  EXPECT_EQ(shortFlags("cf1 0, cf4 -1, cf6 0, cfx 1"), "[0,-1,0,1]");
  EXPECT_EQ(shortFlags("S 2, T 35"), "S 2, T 35");
  EXPECT_EQ(shortFlags(""), "");
}

TEST(ConfigurationModel, SaysHowTheArmStandsAndWhyARowIsOut) {
  const workcell::Entity robot = libraryRobot("kuka_kr16_2");
  const std::vector<double> now = robot.joints();
  kinematics::ListedSolution here, over, other;
  here.q = now;
  here.within_limits = here.is_now = true;
  here.configuration = "front, elbow up, wrist not flipped";
  here.maker_flags = "S 2, T 2";
  over = here;
  over.is_now = over.within_limits = false;
  over.q[1] = robot.robot()->joints[static_cast<std::size_t>(robot.robot()->moving[1])].upper + 0.2;
  over.limiting_joint = robot.robot()->moving[1];
  other = here;
  other.is_now = false;
  other.q[0] += 1.0;
  other.q[3] -= 0.5;
  ConfigurationModel model;
  model.setSolutions(robot.robot().get(), {here, other, over}, now, "KUKA");
  const auto text = [&](int row, int column) {
    return model.data(model.index(row, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(text(0, 0), "front · up · no flip");
  EXPECT_EQ(text(0, 1), "S 2, T 2");
  EXPECT_EQ(text(0, 2), "current");
  EXPECT_EQ(text(1, 2), "86° in total");
  EXPECT_EQ(text(2, 2), "A2 over limit by 11.5°");
  EXPECT_EQ(model.reachable(), 2);
  EXPECT_EQ(model.rowOf(other.q), 1);
  model.setWay(1, false, "Clamp tower B", "link_4 would touch Clamp tower B after 43 % of the way");
  EXPECT_EQ(text(1, 2), "touches Clamp tower B");
  EXPECT_EQ(model.way(1), ConfigurationModel::Way::kBlocked);
}

}  // namespace
}  // namespace hapticell::app
