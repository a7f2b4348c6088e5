// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/command_listener.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/command_line.h"

namespace hapticell::cli {

namespace {

class Heard final : public CommandListener {
 public:
  void hearResult(const nlohmann::ordered_json& result) override { results.push_back(result); }
  void hearText(const std::string& text) override { texts += text; }
  void hearError(const Error& error) override { errors.push_back(error); }
  void hearWarning(const Text&) override {}
  void hearProgress(double, const std::string&) override {}

  std::vector<nlohmann::ordered_json> results;
  std::string texts;
  std::vector<Error> errors;
};

}  // namespace

TEST(CommandListener, HearsTheResultInsteadOfStandardOutput) {
  Heard heard;
  testing::internal::CaptureStdout();
  EXPECT_EQ(runCommand({"mannequin", "--sex", "male", "--stature", "1.8"}, heard), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  ASSERT_EQ(heard.results.size(), 1u);
  EXPECT_EQ(heard.results[0]["dof"], 56);
  EXPECT_EQ(commandListener(), nullptr);
}

TEST(CommandListener, HearsErrorsByTheirParts) {
  Heard heard;
  testing::internal::CaptureStderr();
  EXPECT_EQ(runCommand({"inspect", "none.stl"}, heard), 2);
  EXPECT_EQ(runCommand({"inspect", "--nonsense"}, heard), 2);
  EXPECT_EQ(runCommand({"nonsense"}, heard), 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(heard.errors.size(), 3u);
  EXPECT_EQ(heard.errors[0].file, "none.stl");
  EXPECT_EQ(runCommand({"inspect", "--help"}, heard), 0);
  EXPECT_NE(heard.texts.find("--json"), std::string::npos);
}

TEST(CommandListener, EndsTheLoopsOfACommand) {
  Heard heard;
  const ListenerOfThread listening(heard);
  EXPECT_NO_THROW(stopWhereAsked());
  heard.askToStop();
  EXPECT_THROW(stopWhereAsked(), Stopped);
  EXPECT_EQ(runCommand({"feel", "--only", "M1"}, heard), 2);
  EXPECT_EQ(english(heard.errors.at(0).found), "stopped before its end");
}

TEST(CommandGrammar, ListsEachCommandWithItsOptions) {
  const auto grammar = commandGrammar();
  const auto distance =
      std::find_if(grammar.begin(), grammar.end(), [](const auto& one) { return one["name"] == "distance"; });
  ASSERT_NE(distance, grammar.end());
  EXPECT_EQ((*distance)["runs"], true);
  const auto& options = (*distance)["options"];
  const auto named = [&](const char* name) {
    return *std::find_if(options.begin(), options.end(), [&](const auto& one) { return one["name"] == name; });
  };
  EXPECT_EQ(named("--moving")["required"], true);
  EXPECT_EQ(named("--environment")["values"], nlohmann::ordered_json({1, -1}));
  EXPECT_EQ(named("--fail-on-contact")["flag"], true);
  EXPECT_EQ(named("--poses")["kind"], "CSV");
}

}  // namespace hapticell::cli
