// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "cli/kit/action.h"
#include "cli/kit/command_listener.h"
#include "cli/kit/subcommand.h"
#include "tests/support/test_data.h"

namespace hapticell::cli::test {

using hapticell::test::TemporaryFolder;

/// Keeps what a command says.
class KeptWords final : public CommandListener {
 public:
  void hearResult(const nlohmann::ordered_json& result) override { results.push_back(result); }
  void hearText(const std::string& text) override { texts += text; }
  void hearError(const Error& error) override { errors.push_back(error); }
  void hearWarning(const Text& sentence) override { warnings.push_back(sentence); }
  void hearProgress(double /*share*/, const std::string& /*stage*/) override {}

  std::vector<nlohmann::ordered_json> results;
  std::string texts;
  std::vector<Error> errors;
  std::vector<Text> warnings;
};

/// A command line with nothing but the commands that a test adds.
class OneCommand {
 public:
  using Add = void (*)(Subcommand, Action&);

  explicit OneCommand(std::initializer_list<Add> adds) {
    for (const Add add : adds) add(Subcommand(app_), chosen_);
  }

  /// What the parser has against these words; empty: nothing, and an action is chosen.
  std::string refusal(std::vector<std::string> words) {
    chosen_ = nullptr;
    std::reverse(words.begin(), words.end());  // As CLI11 wants a vector of them.
    try {
      app_.parse(std::move(words));
    } catch (const CLI::ParseError& problem) {
      EXPECT_FALSE(chosen_) << "nothing may run after refused words";
      return problem.what();
    }
    return chosen_ ? "" : "no action was chosen";
  }

  /// Runs accepted words; `kept` hears what the command says.
  ExitStatus run(const std::vector<std::string>& words) {
    EXPECT_EQ(refusal(words), "");
    if (!chosen_) return ExitStatus::kBadInput;
    const ListenerOfThread listening(kept);
    ResultWriter writer("-");
    return chosen_(writer);
  }

  /// Runs words that end in one error and no result, and gives its sentence.
  std::string error(const std::vector<std::string>& words) {
    const std::size_t before = kept.errors.size(), results = kept.results.size();
    EXPECT_EQ(run(words), ExitStatus::kBadInput);
    EXPECT_EQ(kept.errors.size(), before + 1);
    EXPECT_EQ(kept.results.size(), results);
    return kept.errors.empty() ? std::string() : kept.errors.back().message();
  }

  /// Names of the commands below `command` (empty: of all).
  std::vector<std::string> below(const std::string& command = {}) const {
    const CLI::App* const app = command.empty() ? &app_ : app_.get_subcommand(command);
    std::vector<std::string> names;
    for (const CLI::App* each : app->get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(each->get_name());
    return names;
  }

  KeptWords kept;

 private:
  CLI::App app_;
  Action chosen_;
};

/// Words of a command line, and a part of what the parser has against them (empty: they are accepted).
struct WordsCase {
  std::vector<std::string> words;
  const char* refusal;
};

inline void expectRefusals(std::initializer_list<OneCommand::Add> adds, const std::vector<WordsCase>& cases) {
  for (const WordsCase& each : cases) {
    std::string line;
    for (const std::string& word : each.words) line += word + " ";
    OneCommand command(adds);
    const std::string refusal = command.refusal(each.words);
    if (*each.refusal == '\0') {
      EXPECT_EQ(refusal, "") << line;
    } else {
      EXPECT_NE(refusal.find(each.refusal), std::string::npos) << line << ": '" << refusal << "'";
    }
  }
}

}  // namespace hapticell::cli::test
