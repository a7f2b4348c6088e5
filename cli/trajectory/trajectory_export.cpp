// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_export.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/trajectory/motion_of_robot.h"
#include "cli/trajectory/trajectory_report.h"
#include "geometry/system/scratch_folder.h"
#include "geometry/system/text_case.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/checks/program_promises.h"
#include "trajectory/files/ros_trajectory.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

const std::map<std::string, trajectory::ProgramFormat>& programFormats() {
  using trajectory::ProgramFormat;
  static const std::map<std::string, ProgramFormat> kFormats{
      {"krl", ProgramFormat::kKrl},           {"rapid", ProgramFormat::kRapid}, {"fanuc", ProgramFormat::kFanuc},
      {"urscript", ProgramFormat::kUrScript}, {"val3", ProgramFormat::kVal3},   {"inform", ProgramFormat::kInform}};
  return kFormats;
}

/// Controllers look for a program under its own name.
void noteFileName(const std::string& name, const std::string& file, trajectory::ProgramFormat format,
                  std::vector<Text>& notes) {
  using trajectory::ProgramFormat;
  const bool is_found_by_name = format != ProgramFormat::kUrScript && format != ProgramFormat::kRapid;
  if (is_found_by_name && !sameButForCase(name, file))
    notes.push_back(Text("On the controller the file must be named '%1', as its program.", name));
}

/// What stands in the program's files on the disk, written aside, of which nothing is left.
Expected<std::vector<trajectory::ProgramFile>> readBack(const std::vector<trajectory::ProgramFile>& files,
                                                        const fs::path& wanted) {
  std::error_code problem;
  const fs::path beside = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  fs::create_directories(beside, problem);
  if (problem)
    return makeError({.file = beside.string(),
                      .found = "the folder cannot be created",
                      .expected = problem.message(),
                      .fix = "Write it somewhere else."});
  const auto folder = ScratchFolder::make(beside);
  HAPTICELL_TRY(folder);
  std::vector<trajectory::ProgramFile> read;
  for (const auto& file : files) {
    const fs::path path = folder->path() / fs::path(file.name).filename();
    if (auto written = writeFileAtomically(path, file.content, {.durable = false}); !written)
      return tl::unexpected(written.error());
    auto content = workcell::readFileContent(path);
    HAPTICELL_TRY(content);
    read.push_back({file.name, std::move(*content)});
  }
  return read;
}

/// Writes what was read back and measured.
Expected<std::vector<std::string>> saveProgram(const std::vector<trajectory::ProgramFile>& files,
                                               trajectory::ProgramFormat format, const fs::path& wanted) {
  std::vector<std::string> names;
  std::vector<workcell::FileToWrite> contents;
  for (const auto& file : trajectory::placedProgram(files, format, wanted)) {
    const fs::path path = file.name;
    std::error_code problem;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), problem);
    if (problem)
      return makeError({.file = path.parent_path().string(),
                        .found = "the folder cannot be created",
                        .expected = problem.message()});
    contents.push_back({path, file.content});
    names.push_back(path.string());
  }
  HAPTICELL_TRY(workcell::writeFilesAtomically(contents));
  return names;
}

/// As csv, json or ros.
Expected<void> exportText(const Trajectory& given, const TrajectoryOptions& options, ordered_json& result) {
  Expected<std::string> text = options.to == "csv" ? toCsvText(given) : toJsonText(given);
  if (options.to == "ros") text = toRosText(given);
  HAPTICELL_TRY(text);
  const bool ros = options.to == "ros";
  std::string extension = options.to == "csv" ? ".csv" : ".htraj";
  if (ros) extension = ".yaml";
  const auto measure = [&](const fs::path& written) {
    return trajectory_checks::copyPromises(given, !ros, ros ? 1e-9 : 0.0, written);
  };
  if (fs::path(options.output).extension() == extension || (options.to == "json" && options.output.ends_with(".json")))
    return writeKept(options.output, *text, extension, options.allow_miss, measure, result);
  // Read back under an extension that says what it is, then written under the name that was asked for.
  if (auto kept = writeKept("", *text, extension, options.allow_miss, measure, result); !kept) return kept;
  return writeFileAtomically(options.output, *text);
}

/// As a robot's program.
Expected<void> exportAsProgram(const Trajectory& given, const TrajectoryOptions& options, std::vector<Text>& notes,
                               ordered_json& result) {
  const auto format = programFormats().find(options.to);
  if (format == programFormats().end()) {
    return makeError({.place = "--to",
                      .found = "'" + options.to + "'",
                      .expected = "csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform"});
  }
  trajectory::ProgramOptions program = options.program;
  if (program.name.empty()) program.name = fs::path(options.output).stem().string();
  program.must_read_back = !options.allow_miss;
  if (auto found = addConfigurations(given, options.limits.robot, format->second, program, notes); !found) return found;
  const auto files = exportProgram(given, format->second, program, &notes);
  HAPTICELL_TRY(files);
  const auto read = readBack(*files, options.output);
  HAPTICELL_TRY(read);
  const auto promises = trajectory_checks::programPromises(given, *read, format->second, program);
  HAPTICELL_TRY(promises);
  if (auto told = reportPromises(*promises, options.output, options.allow_miss, result); !told) return told;
  const std::string stem = fs::path(options.output).stem().string();
  noteFileName(fs::path(files->front().name).stem().string(), stem, format->second, notes);
  auto saved = saveProgram(*read, format->second, options.output);
  HAPTICELL_TRY(saved);
  result["files"] = std::move(*saved);
  return {};
}

}  // namespace

Expected<ordered_json> exportTrajectory(const Trajectory& file, const TrajectoryOptions& options) {
  std::vector<Text> notes = options.notes;
  const auto with = withRobot(file, options, notes);
  HAPTICELL_TRY(with);
  const Trajectory& given = with->motion;
  ordered_json result{
      {"format", options.to}, {"files", {options.output}}, {"frames", given.size()}, {"notes", nullptr}};
  const bool is_text = options.to == "csv" || options.to == "json" || options.to == "ros";
  const auto written = is_text ? exportText(given, options, result) : exportAsProgram(given, options, notes, result);
  HAPTICELL_TRY(written);
  result["notes"] = notes;
  return result;
}

}  // namespace hapticell::cli
