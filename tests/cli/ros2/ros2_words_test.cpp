// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/ros2_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/ros2/bridge_call.h"
#include "cli/ros2/package_command.h"
#include "cli/ros2/ros_words.h"
#include "cli/ros2/send_command.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(Ros2Command, TakesItsWords) {
  test::expectRefusals({addRos2Command},
                       {{{"ros2"}, "subcommand is required"},
                        {{"ros2", "package", "--workcell", "a.hcell"}, "--output is required"},
                        {{"ros2", "package", "--workcell", "a.hcell", "-o", "b", "--samples", "0"}, "--samples"},
                        {{"ros2", "send", "--workcell", "a.hcell", "--motion", "b.htraj"}, "--action is required"},
                        {{"ros2", "send", "--workcell", "a.hcell", "--motion", "b.htraj", "--action", "/c", "--joint-share", "2"},
                         "--joint-share"}});
  EXPECT_THAT(test::OneCommand({addRos2Command}).below("ros2"), ::testing::ElementsAre("publish", "package", "listen", "topics", "send"));
}

/// A variable of the environment for as long as this lives.
class Named {
 public:
  Named(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Named() { unsetenv(name_); }
  Named(const Named&) = delete;
  Named& operator=(const Named&) = delete;

 private:
  const char* name_;
};

TEST(RosWords, TheDomainIsTheWordElseThatOfTheEnvironment) {
  test::expectRefusals({addRos2Command}, {{{"ros2", "listen", "--domain", "233"}, "--domain"},
                                          {{"ros2", "listen", "--domain", "1.5"}, "--domain"}});
  for (const char* wrong : {"233", "-1", "5x", "home"}) {
    const Named domain("ROS_DOMAIN_ID", wrong);
    const auto refused = bridgeResult({{"do", "no job is called so"}}, {});
    ASSERT_FALSE(refused) << wrong;
    EXPECT_THAT(refused.error().message(), ::testing::AllOf(::testing::HasSubstr("ROS_DOMAIN_ID"), ::testing::HasSubstr(wrong)));
  }
  // A word wins: the job goes on to the program, which does not know it.
  const Named domain("ROS_DOMAIN_ID", "home");
  ::testing::internal::CaptureStderr();
  const auto answer = bridgeResult({{"do", "no job is called so"}}, {.domain = 7});
  ::testing::internal::GetCapturedStderr();
  if (answer)
    EXPECT_FALSE(*answer) << "it failed";
  else
    EXPECT_THAT(answer.error().message(), ::testing::HasSubstr("hapticell-ros2 is not installed"));
}

TEST(Ros2Send, SaysWhatAPersonConfirms) {
  const nlohmann::ordered_json preview{{"robot", "arm"},      {"action", "/c/follow_joint_trajectory"}, {"duration", 2.46},
                                       {"slowed", 1.5},       {"tool_speed", 0.2},                      {"joint_share", 0.4},
                                       {"touching_at_start", nlohmann::ordered_json::array({"arm/base / Table"})}};
  EXPECT_EQ(confirmationSentence(preview),
            "Robot 'arm' moves for 2.5 s, its tool at up to 200 mm/s and its fastest joint at 40 % of its limit, on "
            "/c/follow_joint_trajectory. The motion is slowed 1.50 times. Not checked, because they touch at the start: "
            "arm/base / Table.");
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
