// SPDX-License-Identifier: Apache-2.0
// What the parser takes and refuses of fk, ik and library, and their first sentences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/robot/free_inverse.h"
#include "cli/robot/robot_commands.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using ::testing::HasSubstr;

TEST(RobotCommands, TakeTheirWords) {
  test::expectRefusals(
      {addForwardKinematicsCommand, addInverseKinematicsCommand, addLibraryCommand},
      {{{"fk", "--robot", "a.urdf"}, "--joints is required"},
       {{"fk", "--robot", "a.urdf", "--joints", "j.csv", "--on", "rail.urdf,link=x"}, ""},
       {{"ik", "--robot", "a.urdf"}, "--poses is required"},
       {{"ik", "--poses", "p.csv", "--clearance", "-1"}, "a number from 0 to 10"},
       {{"ik", "--poses", "p.csv", "--jobs", "0"}, "--jobs"},
       {{"ik", "--poses", "p.csv", "--collision-free", "--workcell", "a.hcell", "--entity", "robot"}, ""},
       {{"library", "kuka"}, "kuka"}});
  test::OneCommand ik({addInverseKinematicsCommand});
  EXPECT_THAT(ik.error({"ik", "--poses", "p.csv"}), HasSubstr("no robot"));
}

TEST(FreeInverse, NeedsACellAndARobotOfIt) {
  const test::TemporaryFolder folder;
  const std::string poses = folder.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0,0,0.5,1,0,0,0\n").string();
  const std::string cell =
      folder.write("cell.hcell", R"({"format": "hapticell-workcell", "version": 1, "entities": [
        {"name": "block", "source": {"file": "box:1,1,1"}}]})")
          .string();
  FreeInverseOptions options;
  options.asked = true;
  EXPECT_THAT(solveFree(options, poses).error().message(), HasSubstr("--workcell"));
  options.workcell = cell;
  EXPECT_THAT(solveFree(options, poses).error().message(), HasSubstr("--entity"));
  options.entity = "robot";
  const auto unknown = solveFree(options, poses);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message(), HasSubstr("no entity is named 'robot'"));
  EXPECT_THAT(unknown.error().message(), HasSubstr("block"));
  EXPECT_THAT(solveFree(options, "/none.csv").error().message(), HasSubstr("none.csv"));
}

}  // namespace
}  // namespace hapticell::cli
