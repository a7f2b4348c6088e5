// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/robot_library.h"

#include <algorithm>

#include "config/configuration.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

bool isPlain(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// A robot of the library that has no robot.toml says no more than its name.
Expected<RobotSheet> sheetOf(const std::string& name, const fs::path& file) {
  if (file.extension() == ".toml") return readRobotSheet(file);
  RobotSheet sheet;
  sheet.name = name;
  if (name == "hc6") sheet = {"HC-6", "HaptiCell", "6-axis", "HaptiCell's own demonstration robot", 12.0, 1.4};
  return sheet;
}

}  // namespace

Expected<fs::path> findLibraryRobot(const std::string& name) {
  for (const char* form : {".toml", "/robot.toml", "/robot.urdf"}) {
    if (!isPlain(name)) break;
    if (const auto file = config::findShippedFile("robots/" + name + form)) return fs::path(*file);
  }
  return makeError({.file = "library:" + name,
                    .found = "the library has no robot of this name",
                    .expected = "a library robot, such as hc6 or ur5e",
                    .fix = "To list the library robots, run hapticell-cli library."});
}

std::vector<LibraryRobot> listLibraryRobots(Diagnostics& diagnostics) {
  std::vector<LibraryRobot> robots;
  const auto folder = config::findShippedFile("robots");
  if (!folder) {
    diagnostics.warn(folder.error().text());
    return robots;
  }
  std::error_code problem;
  for (fs::directory_iterator at(*folder, problem), end; !problem && at != end; at.increment(problem)) {
    const std::string name = at->path().stem().string();
    const bool is_toml = at->path().extension() == ".toml";
    if (!is_toml && !at->is_directory(problem)) continue;
    const auto file = findLibraryRobot(name);
    if (!file) continue;
    LibraryRobot robot{name, {}, *file};
    auto sheet = sheetOf(name, *file);
    if (!sheet) {
      diagnostics.warn(sheet.error().text());
      continue;
    }
    robot.sheet = std::move(*sheet);
    robots.push_back(std::move(robot));
  }
  std::sort(robots.begin(), robots.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return robots;
}

Expected<double> ratedPayload(const std::string& source) {
  constexpr std::string_view kLibrary = "library:";
  if (source.starts_with(kLibrary)) {
    const std::string name = source.substr(kLibrary.size());
    return findLibraryRobot(name)
        .and_then([&](const fs::path& file) { return sheetOf(name, file); })
        .map([](const RobotSheet& sheet) { return sheet.payload; });
  }
  if (fs::path(source).extension() != ".toml") return 0.0;
  return readRobotSheet(source).map([](const RobotSheet& sheet) { return sheet.payload; });
}

}  // namespace hapticell::workcell
