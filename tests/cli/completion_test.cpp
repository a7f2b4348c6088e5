// SPDX-License-Identifier: Apache-2.0
#include "cli/completion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "cli/command_line.h"
#include "cli/completion_scripts.h"
#include "cli/grammar.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// "do [OPTIONS] motion" and "tree leaf".
class SmallGrammarTest : public ::testing::Test {
 protected:
  SmallGrammarTest() {
    Subcommand act = Subcommand(app_).add("do", "Do it\nat once");
    act.option("motion", file_, "A motion").takes(ValueKind::kMotion).required();
    act.option("--robot", robot_, "A robot").takes(ValueKind::kRobot);
    act.option("-l,--language", language_, "Language").among({"en", "fr"});
    act.option("--folder", folder_, "A folder").takes(ValueKind::kFolder);
    act.option("--rise", rise_, "From, to, step").separatedByCommas().values(3);
    act.option("--add", add_, "One more").oneAtATime();
    act.flag("--all", all_, "Everything");
    Subcommand tree = Subcommand(app_).add("tree", "A tree");
    tree.mustGoOn();
    tree.add("leaf", "A leaf");
  }
  CLI::App app_;
  std::string file_, robot_, language_, folder_;
  std::vector<double> rise_;
  std::vector<std::string> add_;
  bool all_ = false;
};

TEST_F(SmallGrammarTest, CompletesCommandsAndTheirOptions) {
  EXPECT_THAT(completions(app_, {""}), ElementsAre("do\tDo it at once", "tree\tA tree"));
  EXPECT_THAT(completions(app_, {}), ElementsAre("do\tDo it at once", "tree\tA tree"));
  EXPECT_THAT(completions(app_, {"tree", "l"}), ElementsAre("leaf\tA leaf"));
  const auto options = completions(app_, {"do", "--"});
  for (const char* line : {"--robot\tA robot", "-l\tLanguage", "--language\tLanguage", "--all\tEverything"})
    EXPECT_THAT(options, Contains(line));
  EXPECT_THAT(options, Contains(StartsWith("--help\t")));
  EXPECT_THAT(completions(app_, {"-"}), Not(Contains(StartsWith("--robot"))));
}

TEST_F(SmallGrammarTest, CompletesValuesByTheirKind) {
  EXPECT_THAT(completions(app_, {"do", "--language", ""}), ElementsAre("en\tLanguage", "fr\tLanguage"));
  EXPECT_THAT(completions(app_, {"do", "--folder", ""}), ElementsAre(":folders"));
  const auto robots = completions(app_, {"do", "--robot", ""});
  EXPECT_THAT(robots, Contains(StartsWith("library:kuka_kr16_2\t")));
  EXPECT_THAT(robots, Contains(":files urdf xacro sdf toml"));
  EXPECT_THAT(completions(app_, {"do", "--rise", "1", ""}), Not(Contains(StartsWith(":files")))) << "still its values";
}

TEST_F(SmallGrammarTest, CompletesThePositionalWordUntilItIsThere) {
  const auto motion = AllOf(StartsWith(":files "), HasSubstr(" csv"), HasSubstr("htraj"));
  EXPECT_THAT(completions(app_, {"do", ""}), ElementsAre(motion));
  EXPECT_THAT(completions(app_, {"do", "--all", ""}), ElementsAre(motion)) << "a flag takes no word";
  EXPECT_THAT(completions(app_, {"do", "--robot=a.urdf", ""}), ElementsAre(motion)) << "it has its value";
  EXPECT_THAT(completions(app_, {"do", "--robot", "a.urdf", ""}), ElementsAre(motion));
  EXPECT_THAT(completions(app_, {"do", "a.csv", ""}), IsEmpty());
}

TEST_F(SmallGrammarTest, PrintsForShellsAndRefusesUnknownOnes) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(runCompletion(app_, {"words", "do", "--language", "e"}), 0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "en\tLanguage\nfr\tLanguage\n") << "the shell filters";
  for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"tcsh"}, {"bash", "zsh"}}) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(runCompletion(app_, words), 2);
    EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("bash, zsh or fish"));
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  }
}

TEST_F(SmallGrammarTest, IsToldAsData) {
  const nlohmann::ordered_json grammar = grammarOf(app_);
  ASSERT_EQ(grammar.size(), 2U);
  EXPECT_EQ(grammar[0]["name"], "do");
  EXPECT_TRUE(grammar[0]["runs"].get<bool>());
  EXPECT_FALSE(grammar[1]["runs"].get<bool>());
  EXPECT_EQ(grammar[1]["commands"][0]["name"], "leaf");
  EXPECT_TRUE(grammar[1]["commands"][0]["commands"].empty());
  std::map<std::string, nlohmann::ordered_json> options;
  for (const auto& option : grammar[0]["options"]) options[option["name"]] = option;
  EXPECT_FALSE(options.contains("--help"));
  ASSERT_EQ(options.size(), 7U);
  const auto expectOption = [&](const char* name, const nlohmann::ordered_json& wanted) {
    for (const auto& [key, value] : wanted.items()) EXPECT_EQ(options[name][key], value) << name << ", " << key;
  };
  expectOption("motion", {{"kind", "MOTION"}, {"positional", true}, {"required", true}, {"values", {1, 1}}});
  expectOption("--language", {{"positional", false}, {"required", false}, {"choices", {"en", "fr"}}, {"flag", false}});
  expectOption("--rise", {{"kind", "FLOAT"}, {"values", {3, 3}}, {"separator", ","}, {"description", "From, to, step"}});
  expectOption("--add", {{"kind", "TEXT"}, {"repeated", true}, {"separator", ""}});
  expectOption("--all", {{"kind", ""}, {"flag", true}, {"values", {0, 0}}});
}

TEST(ProgramGrammar, CompletesEachKindOfResultsByItsOwnFiles) {
  const auto offered = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"hapticell-cli", "completion", "words"});
    std::vector<char*> arguments;
    for (const char* word : words) arguments.push_back(const_cast<char*>(word));
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(runCommandLine(static_cast<int>(arguments.size()), arguments.data()), 0);
    return ::testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(offered({"trajectory", "train", "--results", ""}), ":files htrain\n");
  EXPECT_EQ(offered({"study", "show", ""}), ":files hresults\n");
}

/// Calls `look` with the words that choose each command, and its options.
void forEachCommand(const nlohmann::ordered_json& commands, const std::vector<std::string>& above,
                    const std::function<void(const std::vector<std::string>&, const nlohmann::ordered_json&)>& look) {
  for (const auto& command : commands) {
    std::vector<std::string> words = above;
    words.push_back(command["name"]);
    look(words, command["options"]);
    forEachCommand(command["commands"], words, look);
  }
}

TEST(ProgramGrammar, NoCountOfAnyCommandTakesANegativeNumber) {
  int counts = 0;
  forEachCommand(commandGrammar(), {}, [&](std::vector<std::string> words, const nlohmann::ordered_json& options) {
    for (const auto& option : options) {
      if (option["kind"] != "UINT") continue;
      ++counts;
      const std::string name = option["name"];
      std::vector<std::string> line = words;
      line.push_back(name + "=-1");
      test::KeptWords kept;
      EXPECT_EQ(runCommand(line, kept), 2);
      ASSERT_EQ(kept.errors.size(), 1U) << name;
      EXPECT_THAT(kept.errors[0].message(), HasSubstr(name + ": '-1' found")) << words.back();
    }
  });
  EXPECT_GE(counts, 5) << "those of trajectory edits at least";
}

TEST(CompletionScripts, AreThereForThreeShells) {
  for (const char* shell : {"bash", "zsh", "fish"})
    EXPECT_NE(completionScript(shell).find("completion words"), std::string_view::npos) << shell;
  EXPECT_TRUE(completionScript("tcsh").empty());
  EXPECT_TRUE(completionScript("").empty());
}

TEST(CompletionScripts, BashTakesItsOwn) {
  const test::TemporaryFolder folder;
  const std::string script = folder.write("script", std::string(completionScript("bash"))).string();
  const std::string command = "bash -c '. \"$0\" && complete -p hapticell-cli && complete -p hapticell' " + script;
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(std::system((command + " >/dev/null").c_str()), 0);
  ::testing::internal::GetCapturedStdout();
}

}  // namespace
}  // namespace hapticell::cli
