// SPDX-License-Identifier: Apache-2.0
#include "cli/robot/robot_commands.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

ExitStatus run(const ResultWriter& writer) {
  Diagnostics notes;
  ordered_json robots = ordered_json::array();
  for (const workcell::LibraryRobot& robot : workcell::listLibraryRobots(notes)) {
    const workcell::RobotSheet& sheet = robot.sheet;
    robots.push_back({{"name", robot.name},
                      {"add", "library:" + robot.name},
                      {"title", sheet.name},
                      {"maker", sheet.maker},
                      {"kind", sheet.kind},
                      {"payload", sheet.payload > 0.0 ? ordered_json(sheet.payload) : ordered_json(nullptr)},
                      {"source", sheet.source}});
  }
  for (const Text& note : notes.warnings) warn(note);
  const auto written = writer.write({{"robots", std::move(robots)}, {"warnings", notes.warnings}});
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addLibraryCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("library", "List the library robots that library:NAME loads");
  command.onChosen([&chosen] { chosen = [](ResultWriter& writer) { return run(writer); }; });
}

}  // namespace hapticell::cli
