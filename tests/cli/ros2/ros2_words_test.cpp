// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/ros2_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/ros2/bridge_call.h"
#include "cli/ros2/package_command.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(Ros2Command, TakesItsWords) {
  test::expectRefusals({addRos2Command},
                       {{{"ros2"}, "subcommand is required"},
                        {{"ros2", "package", "--workcell", "a.hcell"}, "--output is required"},
                        {{"ros2", "package", "--workcell", "a.hcell", "-o", "b", "--samples", "0"}, "--samples"}});
  EXPECT_THAT(test::OneCommand({addRos2Command}).below("ros2"), ::testing::ElementsAre("publish", "package", "listen"));
}

TEST(BridgeCall, GivesTheProgramsStatusOrSaysThatItIsNotThere) {
  ::testing::internal::CaptureStderr();
  const auto answer = callBridge("no job is called so");
  const std::string said = ::testing::internal::GetCapturedStderr();
  if (!answer) {
    EXPECT_THAT(answer.error().message(), ::testing::HasSubstr("hapticell-ros2 is not installed"));
    return;
  }
  EXPECT_EQ(answer->status, 2);
  EXPECT_EQ(answer->output, "") << "a refusal is no result";
  EXPECT_NE(said, "");
}

TEST(Ros2Package, IsOfOneRobotOfTheCell) {
  const test::TemporaryFolder folder;
  const std::string cell = folder
                               .write("cell.hcell", R"({"format": "hapticell-workcell", "version": 1, "entities": [
    {"name": "block", "source": {"file": "box:1,1,1"}}]})")
                               .string();
  const std::string output = (folder.path() / "package").string();
  for (const char* entity : {"", "block"}) {
    const auto refused = writeRosPackage({cell, entity, output, 1000});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("0 robots"));
    EXPECT_FALSE(std::filesystem::exists(output));
  }
}

}  // namespace
}  // namespace hapticell::cli
