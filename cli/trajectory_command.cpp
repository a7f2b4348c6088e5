// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/motion_file.h"
#include "cli/trajectory_check.h"
#include "cli/trajectory_edits.h"
#include "cli/trajectory_robot.h"
#include "trajectory/program_export.h"
#include "trajectory/retiming.h"
#include "trajectory/ros_trajectory.h"
#include "trajectory/simplification.h"
#include "trajectory/smoothing.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

struct TrajectoryOptions {
  std::string file;
  std::string output;
  double tolerance = 0.001;
  double angle_tolerance = 0.017453292519943295;
  std::string mode = "time-optimal";
  double speed = 0.1;
  double sample = 0.01;
  RobotLimitOptions limits;
  std::string to;
  trajectory::ProgramOptions program;
  TrajectoryCheckOptions check;
  std::vector<std::string> notes;  ///< Of reading the file.
};

ordered_json distanceJson(const trajectory::PoseDistance& distance) {
  return {{"position", distance.position}, {"angle", distance.angle}};
}

/// What a motion is like, for every command's report.
ordered_json summary(const Trajectory& trajectory) {
  double length = 0.0, turned = 0.0, speed = 0.0;
  dvec3 low(0.0), high(0.0);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const dvec3& p = trajectory[i].X_WT.p;
    low = i == 0 ? p : glm::min(low, p);
    high = i == 0 ? p : glm::max(high, p);
    if (i == 0) continue;
    const auto step = trajectory::distanceBetween(trajectory[i - 1].X_WT, trajectory[i].X_WT);
    length += step.position;
    turned += step.angle;
    speed = std::max(speed, step.position / (trajectory[i].t - trajectory[i - 1].t));
  }
  ordered_json result{
      {"frames", trajectory.size()}, {"duration", trajectory.duration()}, {"length", length}, {"rotation", turned},
      {"max_speed", speed},          {"rms_jerk", rmsJerk(trajectory)}};
  result["bounds"] = {{"min", toJson(low)}, {"max", toJson(high)}};
  return result;
}

ExitStatus failed(const Error& error) {
  report(error);
  return ExitStatus::kBadInput;
}

Expected<trajectory::PathTolerance> toleranceOf(const TrajectoryOptions& options) {
  if (!(options.tolerance > 0.0) || !(options.angle_tolerance > 0.0)) {
    return makeError({"", "--tolerance, --angle-tolerance", "a value that is not positive", "metres and radians", ""});
  }
  return trajectory::PathTolerance{options.tolerance, options.angle_tolerance};
}

Expected<ordered_json> info(const Trajectory& given, const TrajectoryOptions& options) {
  ordered_json result = summary(given);
  result["name"] = given.name;
  result["entity"] = given.entity;
  result["moved"] = given.moved;
  result["joints"] = given.joint_names;
  const auto tremor = estimateTremor(given);
  result["tremor"] = {{"position", tremor.position}, {"angle", tremor.angle}};
  const auto moving = withoutStillFrames(given, {1e-6, 1e-6});
  result["still_frames"] = given.size() - moving.size();
  std::size_t by_hand = 0;
  for (const auto& frame : given.frames()) by_hand += frame.by_hand ? 1 : 0;
  result["frames_by_hand"] = by_hand;
  result["points"] = ordered_json::array();
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].name) result["points"].push_back({{"frame", i}, {"name", *given[i].name}});
  result["start"] = given.empty() ? ordered_json(nullptr) : ordered_json(given[0].t);
  result["notes"] = options.notes;
  return result;
}

Expected<ordered_json> simplify(const Trajectory& given, const TrajectoryOptions& options) {
  const auto tolerance = toleranceOf(options);
  if (!tolerance) return tl::unexpected(tolerance.error());
  const Trajectory few = simplified(given, *tolerance);
  if (auto saved = saveTrajectory(few, options.output); !saved) return tl::unexpected(saved.error());
  return ordered_json{{"frames_before", given.size()},
                      {"frames_after", few.size()},
                      {"max_deviation", distanceJson(largestDeviation(given, few))}};
}

Expected<ordered_json> smooth(const Trajectory& given, const TrajectoryOptions& options) {
  const auto tolerance = toleranceOf(options);
  if (!tolerance) return tl::unexpected(tolerance.error());
  auto result = trajectory::smoothed(given, {*tolerance});
  ordered_json kept = nullptr;
  if (!options.check.workcell.empty()) {
    auto free = keepFree(given, std::move(result.trajectory), options.check);
    if (!free) return tl::unexpected(free.error());
    result.trajectory = std::move(free->trajectory);
    kept = std::move(free->report);
  }
  if (auto saved = saveTrajectory(result.trajectory, options.output); !saved) return tl::unexpected(saved.error());
  const auto& report = result.report;
  ordered_json json{{"frames", given.size()},
                    {"spans", report.spans},
                    {"max_deviation", distanceJson(report.max_deviation)},
                    {"rms_deviation", report.rms_deviation},
                    {"rms_jerk_before", report.rms_jerk_before},
                    {"rms_jerk_after", report.rms_jerk_after}};
  json["tremor"] = {{"position", report.tremor.position}, {"angle", report.tremor.angle}};
  if (!kept.is_null()) json["kept_free"] = std::move(kept);
  json["warnings"] = ordered_json::array();
  if (report.tremor_exceeds_tolerance) {
    json["warnings"].push_back("The hand's tremor is larger than the tolerance: much of it is kept.");
  }
  return json;
}

Expected<ordered_json> retime(const Trajectory& given, const TrajectoryOptions& options) {
  trajectory::RetimingOptions retiming;
  retiming.sample_s = options.sample;
  retiming.speed = options.speed;
  std::vector<std::string> assumptions;
  if (!(options.sample > 0.0)) return makeError({"", "--sample", "a value that is not positive", "seconds", ""});
  if (options.mode == "constant-speed") {
    retiming.mode = trajectory::TimingMode::kConstantSpeed;
    if (!options.limits.acceleration.empty()) retiming.acceleration = options.limits.acceleration.front();
  } else if (options.mode == "time-optimal") {
    auto limits = limitsFor(given, options.limits, assumptions);
    if (!limits) return tl::unexpected(limits.error());
    retiming.limits = std::move(*limits);
  } else {
    return makeError({"", "--mode", "'" + options.mode + "'", "time-optimal or constant-speed", ""});
  }
  ordered_json kept = nullptr;
  trajectory::Retimed made;
  if (options.check.workcell.empty()) {
    auto result = trajectory::retimed(given, retiming);
    if (!result) return tl::unexpected(result.error());
    made = std::move(*result);
  } else {
    auto free = retimeFree(given, retiming, options.check, made.report);
    if (!free) return tl::unexpected(free.error());
    made.trajectory = std::move(free->trajectory);
    kept = std::move(free->report);
  }
  if (auto saved = saveTrajectory(made.trajectory, options.output); !saved) return tl::unexpected(saved.error());
  const auto& report = made.report;
  ordered_json json{
      {"duration_before", report.duration_before},
      {"duration_after", report.duration_after},
      {"frames", made.trajectory.size()},
      {"still_frames", report.still_frames},
      {"max_deviation", distanceJson(report.max_deviation)},
      {"max_joint_deviation", report.max_joint_deviation},
      {"limit_use",
       {{"velocity", report.use.velocity}, {"acceleration", report.use.acceleration}, {"jerk", report.use.jerk}}},
      {"assumptions", assumptions}};
  if (!kept.is_null()) json["kept_free"] = std::move(kept);
  return json;
}

const std::map<std::string, trajectory::ProgramFormat>& programFormats() {
  using trajectory::ProgramFormat;
  static const std::map<std::string, ProgramFormat> kFormats{
      {"krl", ProgramFormat::kKrl},           {"rapid", ProgramFormat::kRapid}, {"fanuc", ProgramFormat::kFanuc},
      {"urscript", ProgramFormat::kUrScript}, {"val3", ProgramFormat::kVal3},   {"inform", ProgramFormat::kInform}};
  return kFormats;
}

/// Controllers look for a program under its own name.
void noteFileName(const std::string& name, const std::string& file, trajectory::ProgramFormat format,
                  std::vector<std::string>& notes) {
  using trajectory::ProgramFormat;
  const bool is_found_by_name = format != ProgramFormat::kUrScript && format != ProgramFormat::kRapid;
  const auto isSame = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  if (is_found_by_name && !std::equal(name.begin(), name.end(), file.begin(), file.end(), isSame))
    notes.push_back("On the controller the file must be called '" + name + "', as its program.");
}

Expected<std::vector<std::string>> saveProgram(const std::vector<trajectory::ProgramFile>& files,
                                               trajectory::ProgramFormat format, const fs::path& wanted) {
  std::vector<std::string> names;
  for (const auto& file : trajectory::placedProgram(files, format, wanted)) {
    const fs::path path = file.name;
    std::error_code problem;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), problem);
    if (problem)
      return makeError({path.parent_path().string(), "", "the folder cannot be made", problem.message(), ""});
    if (auto written = writeFileAtomically(path.string(), file.content); !written)
      return tl::unexpected(written.error());
    names.push_back(path.string());
  }
  return names;
}

Expected<ordered_json> exportTo(const Trajectory& given, const TrajectoryOptions& options) {
  std::vector<std::string> names{options.output};
  std::vector<std::string> notes = options.notes;
  ordered_json promised = nullptr, measured = nullptr;
  if (options.to == "csv" || options.to == "json" || options.to == "ros") {
    Expected<std::string> text = options.to == "csv" ? toCsvText(given) : toJsonText(given);
    if (options.to == "ros") text = toRosText(given);
    if (!text) return tl::unexpected(text.error());
    if (auto written = writeFileAtomically(options.output, *text); !written) return tl::unexpected(written.error());
  } else {
    const auto format = programFormats().find(options.to);
    if (format == programFormats().end()) {
      return makeError(
          {"", "--to", "'" + options.to + "'", "csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform", ""});
    }
    trajectory::ProgramOptions program = options.program;
    if (program.name.empty()) program.name = fs::path(options.output).stem().string();
    if (auto found = addConfigurations(given, options.limits.robot, format->second, program, notes); !found) {
      return tl::unexpected(found.error());
    }
    const auto files = exportProgram(given, format->second, program, &notes);
    if (!files) return tl::unexpected(files.error());
    const auto off = measureProgram(*files, format->second, program, given);
    if (!off) return tl::unexpected(off.error());
    promised = {{"position", trajectory::kProgramPromise.position}, {"angle", trajectory::kProgramPromise.angle}};
    if (*off) measured = distanceJson(**off);
    const std::string stem = fs::path(options.output).stem().string();
    noteFileName(fs::path(files->front().name).stem().string(), stem, format->second, notes);
    auto saved = saveProgram(*files, format->second, options.output);
    if (!saved) return tl::unexpected(saved.error());
    names = std::move(*saved);
  }
  ordered_json result{{"format", options.to}, {"files", names}, {"frames", given.size()}, {"notes", notes}};
  if (!promised.is_null()) {
    result["promised"] = std::move(promised);
    result["measured"] = std::move(measured);
  }
  return result;
}

Expected<ordered_json> check(const Trajectory& given, const TrajectoryOptions& options) {
  return checkTrajectory(given, options.check);
}

using Handler = Expected<ordered_json> (*)(const Trajectory&, const TrajectoryOptions&);

void addTolerance(Subcommand command, TrajectoryOptions& options) {
  command.option("--tolerance", options.tolerance, "Largest deviation of the position, m (0.001)");
  command.option("--angle-tolerance", options.angle_tolerance, "Largest deviation of the orientation, rad (1 deg)");
}

void addLimits(Subcommand command, RobotLimitOptions& limits) {
  command.option("--robot", limits.robot, "Robot whose limits hold: a file or library:NAME");
  command.option("--velocity", limits.velocity, "Joint speeds (rad/s, m/s), or one for all").separatedByCommas();
  command.option("--acceleration", limits.acceleration, "Joint accelerations, or one for all").separatedByCommas();
  command.option("--jerk", limits.jerk, "Joint jerks, or one for all; without it jerk is free").separatedByCommas();
}

}  // namespace

void addTrajectoryCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("trajectory", "Look at, clean, time, check and export a recorded motion");
  command.mustGoOn();
  const auto options = std::make_shared<TrajectoryOptions>();
  const auto add = [&](const char* name, const char* description, Handler handler) {
    Subcommand sub = command.add(name, description);
    sub.option("file", options->file,
               "A trajectory: .htraj, .csv, .json, .yaml (ROS), or a program: .src, .mod, .ls, .script, .jbi")
        .required();
    sub.onChosen([options, &chosen, handler] {
      chosen = [options, handler](ResultWriter& writer) {
        options->notes.clear();
        const auto given = readMotionFile(options->file, options->limits.robot, &options->notes);
        if (handler != info && handler != exportTo)
          for (const std::string& note : options->notes) warn(note);
        return given ? finishTrajectory(writer, handler(*given, *options)) : failed(given.error());
      };
    });
    return sub;
  };
  Subcommand info_command = add("info", "What the motion is like", info);
  info_command.option("--robot", options->limits.robot,
                      "Robot for programs with targets by joints: a file or library:NAME");
  Subcommand simplify_command = add("simplify", "Fewer frames within a tolerance", simplify);
  Subcommand smooth_command = add("smooth", "Take a hand's tremor, keep the path", smooth);
  Subcommand retime_command = add("retime", "New times along the same path", retime);
  Subcommand check_command = add("check", "Limits and collisions along the whole motion", check);
  Subcommand export_command = add("export", "Write it in another format or as a robot's program", exportTo);

  addTrajectoryEdits(command, chosen);
  addTrajectoryTraining(command, chosen);

  for (Subcommand sub : {simplify_command, smooth_command, retime_command}) {
    sub.option("-o,--output", options->output, "The result: .htraj, .json or .csv");
  }
  addTolerance(simplify_command, *options);
  addTolerance(smooth_command, *options);
  retime_command.option("--mode", options->mode, "time-optimal (default) or constant-speed");
  retime_command.option("--speed", options->speed, "m/s, for constant-speed (0.1)");
  retime_command.option("--sample", options->sample, "Time between the frames of the result, s (0.01)");
  addLimits(retime_command, options->limits);
  addCheckOptions(check_command, options->check);
  for (Subcommand sub : {smooth_command, retime_command}) {
    sub.option("--workcell", options->check.workcell,
               "The cell to move through: nearer to the recording where it would collide");
    sub.option("--entity", options->check.entity, "What moves (as the trajectory says)");
  }

  export_command.option("--to", options->to, "csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform").required();
  export_command.option("-o,--output", options->output, "The file; a folder for val3").required();
  export_command.option("--name", options->program.name, "The program's name (of the file)");
  export_command.option("--tool", options->program.tool,
                        "The controller's tool: its name; a number for fanuc and inform");
  export_command.option("--base", options->program.base, "The controller's base, work object or user frame, likewise");
  export_command.option("--speed", options->program.speed, "m/s along lines (0.25)");
  export_command.option("--acceleration", options->program.acceleration, "m/s2 along lines (1.2)");
  export_command.option("--joint-speed", options->program.joint_speed, "Share of the first move's speed (0.2)");
  export_command.option("--blend", options->program.blend, "m (0.002)");
  export_command.option("--robot", options->limits.robot,
                        "Robot for the configuration data and joints: a file or library:NAME");
}

}  // namespace hapticell::cli
