// SPDX-License-Identifier: Apache-2.0
// Written robots are read again with our own reader; where each link stands is the second method.
#include "workcell/robots/urdf_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/support/test_data.h"
#include "workcell/files/scene_export.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::workcell {
namespace {

Pose randomPose(std::mt19937& random) {
  std::normal_distribution<double> any;
  const dquat q(any(random), any(random), any(random), any(random));
  return {dvec3(any(random), any(random), any(random)), glm::normalize(q)};
}

void expectSameLinks(const Entity& written, const kinematics::RobotModel& read) {
  ASSERT_EQ(read.dof(), written.robot()->dof());
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<double> q;
  for (int index : written.robot()->moving) {
    const kinematics::Joint& joint = written.robot()->joints[static_cast<std::size_t>(index)];
    const double lower = std::max(joint.lower, -3.0), upper = std::min(joint.upper, 3.0);
    q.push_back(lower + part(random) * (upper - lower));
  }
  std::vector<Pose> X_BL, X_WL;
  kinematics::forwardKinematics(*written.robot(), q, X_BL);
  kinematics::forwardKinematics(read, q, X_WL);
  for (std::size_t k = 0; k < written.robot()->links.size(); ++k) {
    const int there = read.findLink(written.robot()->links[k].name);
    ASSERT_GE(there, 0) << written.robot()->links[k].name;
    const Twist apart = difference(X_WL[static_cast<std::size_t>(there)], written.X_WE * X_BL[k]);
    EXPECT_LT(glm::length(apart.linear), 1e-9);
    EXPECT_LT(glm::length(apart.angular), 1e-7);
  }
}

TEST(UrdfWriter, ARobotStandsOnItsNewBaseInTheFile) {
  test::TemporaryFolder folder;
  Diagnostics notes;
  std::mt19937 random(5);
  for (const char* name : {"library:ur5e", "library:kuka_kr120_r2500"}) {
    EntityLoader loader(folder.path());
    auto robot = loader.load(name, 1.0, notes);
    ASSERT_TRUE(robot) << robot.error().message();
    robot->X_WE = randomPose(random);
    const auto file = folder.path() / "moved.urdf";
    const auto done = writeUrdf(*robot, file, notes);
    ASSERT_TRUE(done) << done.error().message();
    const auto read = readRobot(file, notes);
    ASSERT_TRUE(read) << read.error().message();
    expectSameLinks(*robot, read->model);
    std::size_t before = 0, after = 0;
    for (const auto& link : robot->robot()->links) before += link.visuals.size();
    for (const auto& link : read->model.links) after += link.visuals.size();
    EXPECT_EQ(before, after);
  }
}

TEST(UrdfWriter, StraightUpAndDownAreNoSpecialCase) {
  test::TemporaryFolder folder;
  folder.write("arm.urdf",
               "<robot name='a&amp;b'><link name='world'/><link name='l'/><joint name='j' type='revolute'>"
               "<parent link='world'/><child link='l'/><origin xyz='0 0 1' rpy='0.3 1.5707963267948966 0.2'/>"
               "<axis xyz='0 1 0'/><limit lower='-1' upper='2' effort='1' velocity='3'/></joint></robot>");
  Diagnostics notes;
  auto robot = EntityLoader(folder.path()).load("arm.urdf", 1.0, notes);
  ASSERT_TRUE(robot) << robot.error().message();
  robot->X_WE = Pose::rotation(glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 1, 0)));
  const auto file = folder.path() / "again.urdf";
  ASSERT_TRUE(writeUrdf(*robot, file, notes));
  const auto read = readRobot(file, notes);
  ASSERT_TRUE(read) << read.error().message();
  expectSameLinks(*robot, read->model);
  EXPECT_GE(read->model.findLink("cell"), 0) << "the name world was taken";
  EXPECT_DOUBLE_EQ(read->model.joints[static_cast<std::size_t>(read->model.moving[0])].velocity, 3.0);
}

TEST(UrdfWriter, WhatIsNoRobotIsRefused) {
  test::TemporaryFolder folder;
  Diagnostics notes;
  EntityLoader loader(folder.path());
  auto box = loader.load("box:1,1,1", 1.0, notes);
  ASSERT_TRUE(box);
  EXPECT_FALSE(writeUrdf(*box, folder.path() / "box.urdf", notes));
  DocumentState state;
  EXPECT_FALSE(exportState(state, folder.path() / "none.urdf", {}, notes));
}

}  // namespace
}  // namespace hapticell::workcell
