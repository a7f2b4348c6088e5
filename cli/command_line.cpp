// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Version.hpp>
#include <algorithm>
#include <clocale>
#include <exception>
#include <iostream>
#include <sstream>

#include "cli/access/access_commands.h"
#include "cli/agents/agents_command.h"
#include "cli/completion.h"
#include "cli/device/device_commands.h"
#include "cli/ergonomics/ergonomics_commands.h"
#include "cli/files/file_commands.h"
#include "cli/grammar.h"
#include "cli/live/live_command.h"
#include "cli/mannequin/mannequin_command.h"
#include "cli/plan/plan_command.h"
#include "cli/robot/robot_commands.h"
#include "cli/ros2/ros2_command.h"
#include "cli/session/session_commands.h"
#include "cli/study/study_commands.h"
#include "cli/trajectory/trajectory_command.h"
#include "cli/workcell/workcell_commands.h"
#include "config/program_version.h"
#include "geometry/system/listed.h"

namespace hapticell::cli {

namespace {

/// The commands of hapticell-cli with their options, and what was chosen of them.
class CommandLine {
 public:
  CommandLine();
  CLI::App& app() { return app_; }
  /// Reads the words (without the program's name), runs what they choose and returns the exit status.
  int run(std::vector<std::string> words);

 private:
  int runChosen() const;

  CLI::App app_{"HaptiCell without a window: inspect, measure, solve and run sessions.", "hapticell-cli"};
  std::string json_file_;
  Action chosen_;
};

CommandLine::CommandLine() {
  app_.set_version_flag("--version", [] { return config::versionText("hapticell-cli", {{"CLI11", CLI11_VERSION}}); });
  app_.require_subcommand(1);
  app_.fallthrough();
  CLI::Option* const json = app_.add_option(
      "--json", json_file_, "Write the result to this file instead of standard output; -: standard output");
  json->type_name(std::string(wordsOf(ValueKind::kJson).word));
  Subcommand words(app_);
  Action& chosen = chosen_;
  // One line a command; each comes with the file that defines it.
  addAccessCommand(words, chosen);
  addAgentsCommand(words, chosen);
  addConvertCommand(words, chosen);
  addDevicesCommand(words, chosen);
  addDistanceCommand(words, chosen);
  addDoctorCommand(words, chosen);
  addErgonomicsCommand(words, chosen);
  addFeelCommand(words, chosen);
  addForwardKinematicsCommand(words, chosen);
  addInspectCommand(words, chosen);
  addInverseKinematicsCommand(words, chosen);
  addLibraryCommand(words, chosen);
  addTrajectoryCommand(words, chosen);
  addMannequinCommand(words, chosen);
  addPairCommand(words, chosen);
  addPlanCommand(words, chosen);
  addWorkcellCommand(words, chosen);
  addRecordCommand(words, chosen);
  addLiveCommand(words, chosen);
  addRos2Command(words, chosen);
  addSessionCommand(words, chosen);
  addStudyCommand(words, chosen);
}

/// CLI11 would only say that a command is missing, not which word it did not know.
int reportUnknownCommand(const CLI::App& app, const std::string& word) {
  const std::string known =
      listed(app.get_subcommands({}), [](const CLI::App* command) { return command->get_name(); });
  report({.found = Text("no command is named '%1'", word), .expected = Text("one of %1", known)});
  return static_cast<int>(ExitStatus::kBadInput);
}

/// The command whose own command is missing or not known: the last of those that were given.
const CLI::App* undecided(const CLI::App& app) {
  const CLI::App* last = &app;
  while (!last->get_subcommands().empty()) last = last->get_subcommands().front();
  return last->get_subcommands([](const CLI::App*) { return true; }).empty() ? nullptr : last;
}

/// Runs what was chosen. Foreign libraries may throw (a disk full, memory gone); a user then reads one sentence.
int CommandLine::runChosen() const {
  ResultWriter writer(json_file_);
  try {
    return static_cast<int>(chosen_(writer));
  } catch (const Stopped&) {
    report({.found = "stopped before its end", .fix = "Start it again."});
  } catch (const std::bad_alloc&) {
    report({.found = "not enough memory", .fix = "Use a smaller or coarser model."});
  } catch (const std::exception& exception) {
    report({.found = Text("unexpected error: %1", exception.what()), .fix = "This is a bug. Please report it."});
  }
  return static_cast<int>(ExitStatus::kBadInput);
}

/// Prints what CLI11 has to say: a help text, or what is wrong with the words.
int sayWhatIsWrong(const CLI::App& app, const CLI::ParseError& problem) {
  std::ostringstream text, wrong;
  const int status = app.exit(problem, text, wrong);
  if (commandListener() == nullptr) {
    std::cout << text.str() << std::flush;
    std::cerr << wrong.str() << std::flush;
  } else if (status == 0) {
    commandListener()->hearText(text.str());
  } else {
    report({.found = Text::plain(problem.what())});
  }
  return status == 0 ? 0 : static_cast<int>(ExitStatus::kBadInput);
}

int CommandLine::run(std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // As CLI11 wants them.
  try {
    app_.parse(std::move(words));
  } catch (const CLI::ParseError& problem) {
    const auto unread = app_.remaining(true);
    const CLI::App* const at = undecided(app_);
    if (at != nullptr && !unread.empty()) return reportUnknownCommand(*at, unread.front());
    return sayWhatIsWrong(app_, problem);
  }
  if (chosen_) return runChosen();
  report({.found = "the command needs a subcommand", .fix = "See hapticell-cli COMMAND --help."});
  return static_cast<int>(ExitStatus::kBadInput);
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  std::setlocale(LC_ALL, "C");
  CommandLine line;
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  // No command of its own: its words may be any of another command's, and it is for shells.
  if (!words.empty() && words.front() == "completion") {
    return runCompletion(line.app(), {words.begin() + 1, words.end()});
  }
  return line.run(words);
}

int runCommand(const std::vector<std::string>& words, CommandListener& listener) {
  const ListenerOfThread listening(listener);
  return CommandLine().run(words);
}

nlohmann::ordered_json commandGrammar() {
  return grammarOf(CommandLine().app());
}

}  // namespace hapticell::cli
