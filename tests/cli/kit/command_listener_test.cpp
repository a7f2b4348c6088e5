// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/command_listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/command_line.h"
#include "geometry/shapes/shapes.h"
#include "tests/cli/kit/kept_words.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Kept = test::KeptWords;

/// Two tetrahedra and poses of one of them, as files.
class CommandListenerTest : public ::testing::Test {
 protected:
  CommandListenerTest() {
    for (const char* name : {"a.obj", "b.obj"})
      std::ofstream(folder_.path() / name) << "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::ofstream(folder_.path() / "poses.csv") << "x,y,z,qw,qx,qy,qz\n-0.3,0,0,1,0,0,0\n-0.2,0,0,1,0,0,0\n";
  }
  std::vector<std::string> distance() const {
    const auto file = [this](const char* name) { return (folder_.path() / name).string(); };
    return {"distance", "--moving", file("a.obj"), "--environment", file("b.obj"), "--poses", file("poses.csv"), "--json=-"};
  }
  test::TemporaryFolder folder_;
  Kept kept_;
};

TEST_F(CommandListenerTest, HearsTheResultAndNothingIsPrinted) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(runCommand(distance(), kept_), 0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  ASSERT_THAT(kept_.results, SizeIs(1));
  EXPECT_THAT(kept_.errors, IsEmpty());
  const auto& rows = kept_.results[0]["results"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0]["distance"].get<double>(), 0.2, 1e-9);  // The faces x = 0.1 - 0.3 and x = 0.
  EXPECT_NEAR(rows[1]["distance"].get<double>(), 0.1, 1e-9);
}

TEST_F(CommandListenerTest, HearsErrorsWithTheirPartsAndHelpAsText) {
  EXPECT_EQ(runCommand({"distance", "--moving", "/none.obj", "--environment", "/none.obj", "--poses",
                        (folder_.path() / "poses.csv").string(), "--json=-"},
                       kept_),
            2);
  ASSERT_THAT(kept_.errors, SizeIs(1));
  EXPECT_THAT(kept_.errors[0].file, HasSubstr("none.obj"));
  EXPECT_EQ(runCommand({"no-such-command"}, kept_), 2);
  EXPECT_THAT(kept_.errors.back().message(), HasSubstr("no-such-command"));
  EXPECT_EQ(runCommand({"distance", "--help"}, kept_), 0);
  EXPECT_THAT(kept_.texts, HasSubstr("--environment"));
  EXPECT_THAT(kept_.results, IsEmpty());
}

TEST_F(CommandListenerTest, OneThatAsksToStopHearsThatAndNoResult) {
  kept_.askToStop();
  EXPECT_EQ(runCommand(distance(), kept_), 2);
  EXPECT_THAT(kept_.results, IsEmpty());
  ASSERT_THAT(kept_.errors, SizeIs(1));
  EXPECT_THAT(kept_.errors[0].message(), HasSubstr("stopped"));
}

TEST_F(CommandListenerTest, TheMeasurementOfTheFeelStopsWithinASession) {
  kept_.askToStop();
  EXPECT_EQ(runCommand({"feel", "--only", "M6", "--full", "--json=-"}, kept_), 2);
  EXPECT_THAT(kept_.results, IsEmpty());
  EXPECT_THAT(kept_.errors.back().message(), HasSubstr("stopped"));
}

TEST_F(CommandListenerTest, IsOfItsThreadAlone) {
  EXPECT_EQ(commandListener(), nullptr);
  EXPECT_EQ(stopFlag(), nullptr);
  EXPECT_NO_THROW(stopWhereAsked());
  {
    const ListenerOfThread outer(kept_);
    EXPECT_EQ(commandListener(), &kept_);
    CommandListener* other = &kept_;
    std::thread([&other] { other = commandListener(); }).join();
    EXPECT_EQ(other, nullptr);
    Kept inner;
    {
      const ListenerOfThread within(inner);
      EXPECT_EQ(commandListener(), &inner);
      inner.askToStop();
      EXPECT_TRUE(*stopFlag());
      EXPECT_THROW(stopWhereAsked(), Stopped);
    }
    EXPECT_EQ(commandListener(), &kept_);
    EXPECT_NO_THROW(stopWhereAsked());
  }
  EXPECT_EQ(commandListener(), nullptr);
}

/// Of a list in the grammar, the entry of this name.
const nlohmann::ordered_json& named(const nlohmann::ordered_json& list, const std::string& name) {
  for (const auto& one : list)
    if (one["name"] == name) return one;
  ADD_FAILURE() << "no " << name;
  return list.front();
}

TEST(CommandGrammar, SaysWhatCanBeGiven) {
  const nlohmann::ordered_json grammar = commandGrammar();
  const auto& distance = named(grammar, "distance");
  EXPECT_TRUE(distance["runs"].get<bool>());
  const auto& poses = named(distance["options"], "--poses");
  EXPECT_TRUE(poses["required"].get<bool>());
  EXPECT_FALSE(poses["flag"].get<bool>());
  EXPECT_FALSE(poses["positional"].get<bool>());
  const auto& until_contact = named(distance["options"], "--until-contact");
  EXPECT_TRUE(until_contact["flag"].get<bool>());
  EXPECT_FALSE(until_contact["required"].get<bool>());
  EXPECT_EQ(until_contact["kind"], "");
  const auto& trajectory = named(grammar, "trajectory");
  EXPECT_FALSE(trajectory["runs"].get<bool>());
  EXPECT_TRUE(named(trajectory["commands"], "retime")["runs"].get<bool>());
}

/// Each command of the grammar is known to the program, and its help names each option of the grammar.
void expectHelpOf(std::vector<std::string> path, const nlohmann::ordered_json& command) {
  path.push_back(command["name"].get<std::string>());
  Kept kept;
  std::vector<std::string> words = path;
  words.emplace_back("--help");
  EXPECT_EQ(runCommand(words, kept), 0) << path.back();
  for (const auto& option : command["options"])
    EXPECT_THAT(kept.texts, HasSubstr(option["name"].get<std::string>())) << path.back();
  for (const auto& below : command["commands"]) expectHelpOf(path, below);
}

TEST(CommandGrammar, IsThatOfTheHelpTexts) {
  for (const auto& command : commandGrammar()) expectHelpOf({}, command);
}

}  // namespace
}  // namespace hapticell::cli
