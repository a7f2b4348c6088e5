// SPDX-License-Identifier: Apache-2.0
#include "cli/completion.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>

#include "cli/completion_scripts.h"
#include "cli/kit/action.h"
#include "cli/kit/value_kind.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::cli {

namespace {

using Lines = std::vector<std::string>;

void addLine(Lines& lines, const std::string& word, std::string meaning) {
  std::replace_if(
      meaning.begin(), meaning.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  lines.push_back(word + '\t' + meaning);
}

/// "{a,b,c}" in what help says of an option's value are the words that it may be.
void addChoices(Lines& lines, const std::string& type, const std::string& meaning) {
  const std::size_t open = type.find('{'), close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return;
  for (std::size_t from = open + 1; from < close;) {
    const std::size_t to = std::min(type.find(',', from), close);
    addLine(lines, type.substr(from, to - from), meaning);
    from = to + 1;
  }
}

void addLibraryRobots(Lines& lines) {
  Diagnostics ignored;
  for (const workcell::LibraryRobot& robot : workcell::listLibraryRobots(ignored))
    addLine(lines, "library:" + robot.name, robot.sheet.name);
}

void addFiles(Lines& lines, const ValueWords& words) {
  if (words.kind == ValueKind::kFolder) return lines.push_back(":folders");
  std::string line = ":files";
  for (const std::string_view ending : words.endings) line.append(" ").append(ending);
  lines.push_back(line);
}

/// What the word after an option, or at a place, may be.
void addValues(Lines& lines, const CLI::Option& option) {
  const std::string type = option.get_type_name();
  addChoices(lines, type, option.get_description());
  for (const ValueWords& words : valueKinds()) {
    if (type != words.word) continue;
    if (words.from_library) addLibraryRobots(lines);
    addFiles(lines, words);
  }
}

bool takesValues(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// The words of a command line as far as they were read.
class ReadWords {
 public:
  explicit ReadWords(const CLI::App& app) : command_(&app) {}

  void take(const std::string& word) {
    if (word.size() > 1 && word[0] == '-') return takeOption(word);
    if (waits_ > 0) return --waits_, void();
    if (const CLI::App* const next = subcommand(word)) {
      command_ = next;
      places_ = 0;
      option_ = nullptr;
    } else {
      ++places_;
    }
  }

  Lines completions(const std::string& last) const {
    Lines lines;
    if (last.size() > 0 && last[0] == '-') {
      for (const CLI::App* app = command_; app != nullptr; app = app->get_parent()) addOptions(lines, *app);
      return lines;
    }
    if (option_ != nullptr && waits_ > 0) {
      addValues(lines, *option_);
      return lines;
    }
    for (const CLI::App* each : command_->get_subcommands([](const CLI::App*) { return true; }))
      addLine(lines, each->get_name(), each->get_description());
    if (const CLI::Option* const place = placed()) addValues(lines, *place);
    return lines;
  }

 private:
  void takeOption(const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    option_ = nullptr;
    for (const CLI::App* app = command_; app != nullptr && option_ == nullptr; app = app->get_parent())
      option_ = app->get_option_no_throw(name);
    const bool has_value = word.find('=') != std::string::npos;
    waits_ = option_ != nullptr && takesValues(*option_) && !has_value ? option_->get_items_expected_max() : 0;
  }

  const CLI::App* subcommand(const std::string& name) const {
    const auto found = command_->get_subcommands([&](const CLI::App* each) { return each->get_name() == name; });
    return found.empty() ? nullptr : found.front();
  }

  /// The positional word that comes next; the last one may take all that follow.
  const CLI::Option* placed() const {
    const auto positional = command_->get_options([](const CLI::Option* each) { return each->get_positional(); });
    int before = 0;
    for (const CLI::Option* each : positional) {
      before += each->get_items_expected_max();
      if (places_ < before) return each;
    }
    return nullptr;
  }

  static void addOptions(Lines& lines, const CLI::App& app) {
    for (const CLI::Option* each : app.get_options()) {
      for (const std::string& name : each->get_lnames()) addLine(lines, "--" + name, each->get_description());
      for (const std::string& name : each->get_snames()) addLine(lines, "-" + name, each->get_description());
    }
  }

  const CLI::App* command_;
  const CLI::Option* option_ = nullptr;  ///< The last one; `waits_` words of its values may follow.
  int waits_ = 0, places_ = 0;
};

}  // namespace

std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words) {
  ReadWords read(app);
  for (std::size_t k = 0; k + 1 < words.size(); ++k) read.take(words[k]);
  return read.completions(words.empty() ? std::string() : words.back());
}

int runCompletion(const CLI::App& app, const std::vector<std::string>& words) {
  if (!words.empty() && words.front() == "words") {
    for (const std::string& line : completions(app, {words.begin() + 1, words.end()})) std::puts(line.c_str());
    return static_cast<int>(ExitStatus::kDone);
  }
  const std::string_view script = words.size() == 1 ? completionScript(words.front()) : std::string_view();
  if (script.empty()) {
    report({.place = "completion", .found = "no shell given", .expected = "bash, zsh or fish"});
    return static_cast<int>(ExitStatus::kBadInput);
  }
  std::fwrite(script.data(), 1, script.size(), stdout);
  return static_cast<int>(ExitStatus::kDone);
}

}  // namespace hapticell::cli
