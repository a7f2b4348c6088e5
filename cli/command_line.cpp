// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Version.hpp>
#include <clocale>
#include <exception>

#include "cli/agents/agents_command.h"
#include "cli/completion.h"
#include "cli/device/device_commands.h"
#include "cli/ergonomics/ergonomics_commands.h"
#include "cli/files/file_commands.h"
#include "cli/mannequin/mannequin_command.h"
#include "cli/robot/robot_commands.h"
#include "cli/session/session_commands.h"
#include "cli/study/study_commands.h"
#include "cli/trajectory/trajectory_command.h"
#include "cli/workcell/workcell_commands.h"
#include "config/program_version.h"
#include "geometry/system/listed.h"

namespace hapticell::cli {

namespace {

/// Runs what was chosen. Foreign libraries may throw (a disk full, memory gone); a user then reads one sentence.
int run(const Action& chosen, const std::string& json_file) {
  ResultWriter writer(json_file);
  try {
    return static_cast<int>(chosen(writer));
  } catch (const std::bad_alloc&) {
    report({.found = "not enough memory", .fix = "Use a smaller or coarser model."});
  } catch (const std::exception& exception) {
    report({.found = Text("unexpected error: %1", exception.what()), .fix = "This is a bug. Please report it."});
  }
  return static_cast<int>(ExitStatus::kBadInput);
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

}  // namespace

int runCommandLine(int argc, char** argv) {
  std::setlocale(LC_ALL, "C");
  CLI::App app("HaptiCell without a window: inspect, measure, solve and run sessions.", "hapticell-cli");
  app.set_version_flag("--version", [] { return config::versionText("hapticell-cli", {{"CLI11", CLI11_VERSION}}); });
  app.require_subcommand(1);
  app.fallthrough();
  std::string json_file;
  CLI::Option* const json = app.add_option(
      "--json", json_file, "Write the result to this file instead of standard output; -: standard output");
  json->type_name(std::string(wordsOf(ValueKind::kJson).word));
  Action chosen;
  Subcommand words(app);
  // One line a command; each comes with the file that defines it.
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
  addWorkcellCommand(words, chosen);
  addSessionCommand(words, chosen);
  addStudyCommand(words, chosen);

  // No command of its own: its words may be any of another command's, and it is for shells.
  if (argc > 1 && std::string_view(argv[1]) == "completion") return runCompletion(app, {argv + 2, argv + argc});
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    const auto unread = app.remaining(true);
    const CLI::App* const at = undecided(app);
    if (at != nullptr && !unread.empty()) return reportUnknownCommand(*at, unread.front());
    return app.exit(problem) == 0 ? 0 : static_cast<int>(ExitStatus::kBadInput);
  }
  if (!chosen) {
    report({.found = "the command needs a subcommand", .fix = "See hapticell-cli COMMAND --help."});
    return static_cast<int>(ExitStatus::kBadInput);
  }
  return run(chosen, json_file);
}

}  // namespace hapticell::cli
