// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/command_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/workcell/document/every_command.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(CommandChecks, NamesArePrintableAndOfUsualLength) {
  for (const std::string& good :
       {std::string("a"), std::string("Gripper G2"), std::string("Türe"), std::string(200, 'x')})
    EXPECT_TRUE(checkName("a name", good).has_value()) << good;
  for (const std::string& bad : {std::string(), std::string(201, 'x'), std::string(" a"), std::string("a "),
                                 std::string("a\nb"), std::string("a\x7f"), std::string("a\0b", 3)})
    EXPECT_FALSE(checkName("a name", bad).has_value()) << bad;
  EXPECT_THAT(checkName("the gripper's name", " a").error().message(), HasSubstr("the gripper's name"));
  EXPECT_EQ(quotedName("Gripper"), "'Gripper'");
  EXPECT_THAT(taken("Gripper").message(), HasSubstr("'Gripper'"));
}

TEST(CommandChecks, PosesAreFiniteAndWithUnitQuaternions) {
  EXPECT_TRUE(checkPose("it", Pose::translation({1.0, 2.0, 3.0})).has_value());
  EXPECT_FALSE(checkPose("it", Pose::translation({1.0, kNaN, 3.0})).has_value());
  EXPECT_FALSE(checkPose("it", Pose{dvec3(0.0), dquat(2.0, 0.0, 0.0, 0.0)}).has_value());
}

TEST(CommandChecks, ReachCountsTheMeshInTheCellAndInItsOwnFrame) {
  EXPECT_TRUE(checkReach("p", {kFarthest, -kFarthest, 0.0}).has_value());
  EXPECT_FALSE(checkReach("p", {0.0, 0.0, -kFarthest - 1e-6}).has_value());
  Entity box = test::makeSolid("box", kFarthest - 0.06);
  EXPECT_TRUE(checkReach(box).has_value());
  box.X_WE.p.x = kFarthest - 0.04;  // The box is 0.1 m wide.
  EXPECT_FALSE(checkReach(box).has_value());
  auto mesh = std::make_shared<geometry::TriangleMesh>(*box.mesh());
  for (dvec3& vertex : mesh->vertices) vertex.x += 3000.0;
  box.body = Solid{mesh};
  box.X_WE.p.x = -3000.0;
  EXPECT_FALSE(checkReach(box).has_value()) << "its own frame: single precision is lost there too";
}

TEST(CommandChecks, JointsToolsAndPosesBelongToTheRobot) {
  Entity arm = test::makeArm("arm");
  EXPECT_TRUE(checkJoints(arm, {0.5}).has_value());
  EXPECT_FALSE(checkJoints(arm, {}).has_value());
  EXPECT_FALSE(checkJoints(arm, {kNaN}).has_value());
  EXPECT_TRUE(checkJoints(test::makeSolid("box"), {}).has_value());
  EXPECT_FALSE(checkJoints(test::makeSolid("box"), {0.0}).has_value());

  arm.editJointed().tip_link = "upper";
  EXPECT_TRUE(checkTool(arm).has_value());
  arm.editJointed().tip_link = "hand";
  EXPECT_THAT(checkTool(arm).error().message(), HasSubstr("'hand'"));
  arm.editJointed().tip_link = "upper";
  arm.editJointed().X_LT.p.x = kNaN;
  EXPECT_FALSE(checkTool(arm).has_value());
  arm.editJointed().X_LT = {};

  arm.editJointed().tools = {{"gun", "upper", {}}, {"probe", "base", {}}};
  EXPECT_TRUE(checkTools(arm).has_value());
  arm.editJointed().tools[1].name = "gun";
  EXPECT_THAT(checkTools(arm).error().message(), HasSubstr("'gun'"));
  arm.editJointed().tools = {{"gun", "hand", {}}};
  EXPECT_FALSE(checkTools(arm).has_value());
  arm.editJointed().tools.clear();

  arm.editJointed().named_poses = {{"home", {0.0}}, {"park", {0.5}}};
  EXPECT_TRUE(checkNamedPoses(arm).has_value());
  arm.editJointed().named_poses[1].name = "home";
  EXPECT_FALSE(checkNamedPoses(arm).has_value());
  arm.editJointed().named_poses = {{"home", {0.0, 1.0}}};
  EXPECT_FALSE(checkNamedPoses(arm).has_value());
}

TEST(CommandChecks, FramesAndPropertiesAreInRange) {
  Entity box = test::makeSolid("box");
  box.frames = {{"top", {}}, {"side", {}}};
  EXPECT_TRUE(checkFrames(box).has_value());
  box.frames[1].name = "top";
  EXPECT_FALSE(checkFrames(box).has_value());
  box.frames = {{"top", Pose::translation({0.0, 0.0, kNaN})}};
  EXPECT_THAT(checkFrames(box).error().message(), HasSubstr("'box', frame 'top'"));

  EXPECT_TRUE(checkProperties(box).has_value());
  for (const double mass : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    box.contact.mass = mass;
    EXPECT_FALSE(checkProperties(box).has_value()) << mass;
  }
  box.contact.mass = 1.0;
  for (const float part : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()}) {
    box.color = {0.0f, part, 1.0f};
    EXPECT_FALSE(checkProperties(box).has_value()) << part;
  }
}

TEST(CommandChecks, PairSetsAndRulesNameDistancesAndEntitiesThatCanBe) {
  EXPECT_TRUE(checkPairSet({.name = "set", .safety_distance = 0.0, .near_miss = 1.0}).has_value());
  for (const double distance : {-1e-9, 1.001, kNaN}) {
    EXPECT_FALSE(checkPairSet({.name = "set", .safety_distance = distance}).has_value()) << distance;
    EXPECT_FALSE(checkPairSet({.name = "set", .near_miss = distance}).has_value()) << distance;
  }
  EXPECT_FALSE(checkPairSet({.name = ""}).has_value());
  PairSet colored{.name = "set"};
  colored.contact_color = {1.0f, 2.0f, 0.0f};
  EXPECT_FALSE(checkPairSet(colored).has_value());

  const Document document = test::cellOfEverything();
  const DocumentState& state = document.state();
  EXPECT_TRUE(checkPairRule({.first = "robot", .first_part = "upper", .second = "table"}, state).has_value());
  EXPECT_FALSE(checkPairRule({.first = "robot", .first_part = "hand", .second = "table"}, state).has_value());
  EXPECT_FALSE(checkPairRule({.first = "table", .first_part = "leg", .second = "robot"}, state).has_value());
  EXPECT_FALSE(checkPairRule({.first = "nobody", .second = "table"}, state).has_value());
  EXPECT_FALSE(checkPairRule({.first = "table", .second = "table"}, state).has_value()) << "with itself";
}

}  // namespace
}  // namespace hapticell::workcell
