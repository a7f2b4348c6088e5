// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/robot_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two joints: a turn about z, then a slide along x, at the end of which is the flange, 0.3 m above.
constexpr const char* kTwoJoints = R"(<robot name="arm"><link name="base"/><link name="column"/><link name="slide"/>
<link name="flange"/><link name="camera"/>
<joint name="out" type="prismatic"><parent link="column"/><child link="slide"/><axis xyz="1 0 0"/>
<limit lower="0" upper="1" velocity="1" effort="1"/></joint>
<joint name="turn" type="revolute"><parent link="base"/><child link="column"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
<joint name="up" type="fixed"><parent link="slide"/><child link="flange"/><origin xyz="0 0 0.3"/></joint>
<joint name="eye" type="fixed"><parent link="base"/><child link="camera"/><origin xyz="0 1 0"/></joint></robot>)";

constexpr const char* kRail = R"(<robot name="rail"><link name="floor"/><link name="carriage"/>
<joint name="ride" type="prismatic"><parent link="floor"/><child link="carriage"/><axis xyz="0 1 0"/>
<limit lower="0" upper="5" velocity="1" effort="1"/></joint></robot>)";

constexpr const char* kTable = R"(<robot name="table"><link name="foot"/><link name="plate"/>
<joint name="spin" type="revolute"><parent link="foot"/><child link="plate"/><origin xyz="0 0 0.7"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" velocity="1" effort="1"/></joint></robot>)";

class RobotOptionsTest : public ::testing::Test {
 protected:
  RobotOptionsTest() {
    arm_ = folder_.write("arm.urdf", kTwoJoints).string();
    rail_ = folder_.write("rail.urdf", kRail).string();
    table_ = folder_.write("table.urdf", kTable).string();
  }
  static Pose tipOf(const RobotWithTip& robot, const std::vector<double>& q) {
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(robot.model, q, X_BL);
    return X_BL[static_cast<std::size_t>(robot.tip)];
  }
  /// The arm alone, by hand.
  static Pose handMade(double turn, double out) {
    return Pose{{0.0, 0.0, 0.0}, quaternionFromRotationVector({0.0, 0.0, turn})} * Pose::translation({out, 0.0, 0.3});
  }
  static void expectSame(const Pose& a, const Pose& b) {
    EXPECT_LT(glm::length(difference(a, b).linear), 1e-12);
    EXPECT_LT(glm::length(difference(a, b).angular), 1e-12);
  }

  hapticell::test::TemporaryFolder folder_;
  std::string arm_, rail_, table_;
  test::KeptWords kept_;
  const ListenerOfThread listening_{kept_};
};

TEST_F(RobotOptionsTest, TheTipIsFoundByNameAndItsJointsAreInOrder) {
  const auto robot = readRobotWithTip(arm_, "flange", workcell::RobotContent::kKinematics);
  ASSERT_TRUE(robot) << robot.error().message();
  EXPECT_THAT(robot->jointNames(), ElementsAre("turn", "out")) << "from base to tip, not as in the file";
  std::vector<double> q(2);
  q[static_cast<std::size_t>(robot->variables[0])] = 0.4;
  q[static_cast<std::size_t>(robot->variables[1])] = 0.25;
  expectSame(tipOf(*robot, q), handMade(0.4, 0.25));
  EXPECT_TRUE(readRobotWithTip(arm_, "camera")->jointNames().empty()) << "nothing moves it";
  EXPECT_THAT(readRobotWithTip(arm_, "column")->jointNames(), ElementsAre("turn"));
}

TEST_F(RobotOptionsTest, WhatIsNoRobotOrNoLinkIsAnError) {
  const auto no_link = readRobotWithTip(arm_, "hand");
  ASSERT_FALSE(no_link);
  for (const char* part : {"arm.urdf", "--tip", "'hand'", "flange"})
    EXPECT_THAT(no_link.error().message(), HasSubstr(part));
  const auto solid = readRobotWithTip(folder_.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string(), "");
  ASSERT_FALSE(solid);
  EXPECT_THAT(solid.error().message(), HasSubstr("not a robot"));
  EXPECT_THAT(readRobotWithTip("/none.urdf", "").error().message(), HasSubstr("none.urdf"));
}

TEST_F(RobotOptionsTest, AXacroTakesItsArgumentsOnTheCommandLine) {
  const std::string file = folder_.write("rod.xacro", R"(<robot name="rod" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="length" default="1"/><link name="base"/><link name="tip"/><joint name="turn" type="continuous">
<parent link="base"/><child link="tip"/><origin xyz="$(arg length) 0 0"/><axis xyz="0 0 1"/></joint></robot>)")
                               .string();
  for (const auto& [text, length] : {std::pair(file, 1.0), std::pair(file + ",length:=2.5", 2.5)}) {
    const auto robot = readRobotWithTip(text, "tip", workcell::RobotContent::kKinematics);
    ASSERT_TRUE(robot) << robot.error().message();
    EXPECT_EQ(tipOf(*robot, {0.0}).p, dvec3(length, 0.0, 0.0));
  }
}

TEST_F(RobotOptionsTest, ExternalAxesComeFirstAndCarryTheRobot) {
  auto robot = readRobotWithTip(arm_, "flange", workcell::RobotContent::kKinematics);
  ASSERT_TRUE(robot);
  const auto added = addExternalAxes({rail_ + ",pose=0,0,0.5,0,1,0,0", ""}, *robot);
  ASSERT_TRUE(added) << added.error().message();
  EXPECT_THAT(robot->jointNames(), ElementsAre("ride", "turn", "out"));
  ASSERT_EQ(robot->model.dof(), 3U);
  std::vector<double> q(3);
  const double values[] = {1.5, 0.4, 0.25};
  for (std::size_t i = 0; i < 3; ++i) q[static_cast<std::size_t>(robot->variables[i])] = values[i];
  // Hung upside down (half a turn about x) half a metre above the carriage.
  const Pose X_CarriageArm{{0.0, 0.0, 0.5}, dquat(0.0, 1.0, 0.0, 0.0)};
  expectSame(tipOf(*robot, q), Pose::translation({0.0, 1.5, 0.0}) * X_CarriageArm * handMade(0.4, 0.25));
}

TEST_F(RobotOptionsTest, AMovedPartIsTheRoot) {
  auto robot = readRobotWithTip(arm_, "flange", workcell::RobotContent::kKinematics);
  ASSERT_TRUE(robot);
  const auto added = addExternalAxes({rail_, table_ + ",link=plate,pose=2,0,0,1,0,0,0"}, *robot);
  ASSERT_TRUE(added) << added.error().message();
  EXPECT_THAT(robot->jointNames(), ElementsAre("spin", "ride", "turn", "out"));
  std::vector<double> q(4);
  const double values[] = {0.9, 1.5, 0.4, 0.25};
  for (std::size_t i = 0; i < 4; ++i) q[static_cast<std::size_t>(robot->variables[i])] = values[i];
  const Pose X_RFoot = Pose::translation({2.0, 0.0, 0.0});
  const Pose X_FootPlate{{0.0, 0.0, 0.7}, quaternionFromRotationVector({0.0, 0.0, 0.9})};
  const Pose X_RTip = Pose::translation({0.0, 1.5, 0.0}) * handMade(0.4, 0.25);
  expectSame(tipOf(*robot, q), (X_RFoot * X_FootPlate).inverse() * X_RTip);
}

TEST_F(RobotOptionsTest, WhatDoesNotMoveCarriesNothing) {
  auto robot = readRobotWithTip(arm_, "flange", workcell::RobotContent::kKinematics);
  ASSERT_TRUE(robot);
  for (const auto& [options, part] : {std::pair(AxisOptions{rail_ + ",link=floor", ""}, "--on: link 'floor' does not move"),
                                      std::pair(AxisOptions{"", table_ + ",link=foot"}, "--part-on: link 'foot' does not move"),
                                      std::pair(AxisOptions{"/none.urdf", ""}, "none.urdf"),
                                      std::pair(AxisOptions{rail_ + ",link=x", ""}, "no link is named 'x'")}) {
    RobotWithTip copy = *robot;
    const auto added = addExternalAxes(options, copy);
    ASSERT_FALSE(added) << part;
    EXPECT_THAT(added.error().message(), HasSubstr(part));
  }
}

}  // namespace
}  // namespace hapticell::cli
