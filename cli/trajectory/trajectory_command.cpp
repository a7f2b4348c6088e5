// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_command.h"

#include <memory>
#include <string>

#include "cli/kit/kept_result.h"
#include "cli/trajectory/motion_file.h"
#include "cli/trajectory/trajectory_check.h"
#include "cli/trajectory/trajectory_edits.h"
#include "cli/trajectory/trajectory_export.h"
#include "cli/trajectory/trajectory_report.h"
#include "cli/trajectory/trajectory_retiming.h"
#include "cli/trajectory/trajectory_smoothing.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;
using trajectory::Trajectory;

ExitStatus failed(const Error& error) {
  report(error);
  return ExitStatus::kBadInput;
}

Expected<ordered_json> check(const Trajectory& given, const TrajectoryOptions& options) {
  return checkTrajectory(given, options.check);
}

using Handler = Expected<ordered_json> (*)(const Trajectory&, const TrajectoryOptions&);

void addTolerance(Subcommand command, TrajectoryOptions& options) {
  command.option("--tolerance", options.tolerance, "Largest deviation of the position, m (0.001)");
  command.option("--angle-tolerance", options.angle_tolerance, "Largest deviation of the orientation, rad (1 deg)");
  command.option("--joint-tolerance", options.joint_tolerance,
                 "Largest deviation of a joint, rad or m (as many milliradians as the tolerance has millimetres)");
}

void addLimits(Subcommand command, RobotLimitOptions& limits) {
  command.option("--robot", limits.robot, "Robot whose limits apply: a file or library:NAME").takes(ValueKind::kRobot);
  command.option("--velocity", limits.velocity, "Joint speeds (rad/s, m/s), or one for all").separatedByCommas();
  command.option("--acceleration", limits.acceleration, "Joint accelerations, or one for all").separatedByCommas();
  command.option("--jerk", limits.jerk, "Joint jerks, or one for all (default: no jerk limit)").separatedByCommas();
}

}  // namespace

void addTrajectoryCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("trajectory", "Analyse, clean, retime, check and export a recorded motion");
  command.mustGoOn();
  const auto options = std::make_shared<TrajectoryOptions>();
  const auto add = [&](const char* name, const char* description, Handler handler) {
    Subcommand sub = command.add(name, description);
    sub.option("file", options->file,
               "Trajectory: .htraj, .csv, .json, .yaml (ROS), .mcap, or program: .src, .mod, .ls, .script, .jbi")
        .takes(ValueKind::kMotion)
        .required();
    sub.onChosen([options, &chosen, handler] {
      chosen = [options, handler](ResultWriter& writer) {
        options->notes.clear();
        const auto given = readMotionFile(options->file, options->limits.robot, &options->notes);
        if (handler != trajectoryInfo && handler != exportTrajectory)
          for (const Text& note : options->notes) warn(english(note));
        return given ? finishTrajectory(writer, handler(*given, *options)) : failed(given.error());
      };
    });
    return sub;
  };
  Subcommand info_command = add("info", "Describe the motion", trajectoryInfo);
  Subcommand simplify_command = add("simplify", "Reduce frames within a tolerance", simplifyTrajectory);
  Subcommand smooth_command = add("smooth", "Remove hand tremor, keep the path", smoothTrajectory);
  Subcommand retime_command = add("retime", "Compute new times along the same path", retimeTrajectory);
  Subcommand check_command = add("check", "Check limits and collisions along the whole motion", check);
  Subcommand export_command = add("export", "Write it in another format or as a robot's program", exportTrajectory);

  addTrajectoryEdits(command, chosen);
  addTrajectoryTraining(command, chosen);

  for (Subcommand sub : {simplify_command, smooth_command, retime_command}) {
    sub.option("-o,--output", options->output, "Result: .htraj, .json or .csv").takes(ValueKind::kMotion);
    addAllowMiss(sub, options->allow_miss);
  }
  addAllowMiss(export_command, options->allow_miss);
  for (Subcommand sub : {info_command, smooth_command}) {
    sub.option("--robot", options->limits.robot, "Robot of the joints, to compute the poses: a file or library:NAME")
        .takes(ValueKind::kRobot);
  }
  retime_command.option("--tolerance", options->passing, "Largest distance from each given frame, m (0.00005)");
  retime_command.option("--angle-tolerance", options->angle_passing,
                        "Largest rotation from it, or of each joint, rad (0.0002)");
  addTolerance(simplify_command, *options);
  addTolerance(smooth_command, *options);
  retime_command.option("--mode", options->mode, "time-optimal (default) or constant-speed");
  retime_command.option("--speed", options->speed, "m/s, for constant-speed (0.1)");
  retime_command.option("--sample", options->sample, "Time between the frames of the result, s (0.01)");
  addLimits(retime_command, options->limits);
  addCheckOptions(check_command, options->check);
  for (Subcommand sub : {smooth_command, retime_command}) {
    sub.option("--workcell", options->check.workcell,
               "Cell to move through; stay closer to the recording to avoid collisions")
        .takes(ValueKind::kWorkcell);
    sub.option("--entity", options->check.entity, "Entity that moves (default: from the trajectory)");
  }

  export_command.option("--to", options->to, "csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform").required();
  export_command.option("-o,--output", options->output, "Output file; a folder for val3")
      .takes(ValueKind::kMotion)
      .required();
  export_command.option("--name", options->program.name, "Program name (default: the file's)");
  export_command.option("--tool", options->program.tool,
                        "Tool in the controller: its name; a number for fanuc and inform");
  export_command.option("--base", options->program.base, "Base, work object or user frame in the controller, likewise");
  export_command.option("--speed", options->program.speed, "Speed along lines, m/s (0.25)");
  export_command.option("--acceleration", options->program.acceleration, "Acceleration along lines, m/s2 (1.2)");
  export_command.option("--joint-speed", options->program.joint_speed, "Speed of the first move, as a share (0.2)");
  export_command.option("--blend", options->program.blend, "m (0.002)");
  export_command
      .option("--robot", options->limits.robot,
              "Robot for configuration data, joints, and poses that the file lacks: a file or library:NAME")
      .takes(ValueKind::kRobot);
}

}  // namespace hapticell::cli
