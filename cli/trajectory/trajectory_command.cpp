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
  command.option("--robot", limits.robot, "Robot whose limits hold: a file or library:NAME").takes(ValueKind::kRobot);
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
        .takes(ValueKind::kMotion)
        .required();
    sub.onChosen([options, &chosen, handler] {
      chosen = [options, handler](ResultWriter& writer) {
        options->notes.clear();
        const auto given = readMotionFile(options->file, options->limits.robot, &options->notes);
        if (handler != trajectoryInfo && handler != exportTrajectory)
          for (const std::string& note : options->notes) warn(note);
        return given ? finishTrajectory(writer, handler(*given, *options)) : failed(given.error());
      };
    });
    return sub;
  };
  Subcommand info_command = add("info", "What the motion is like", trajectoryInfo);
  Subcommand simplify_command = add("simplify", "Fewer frames within a tolerance", simplifyTrajectory);
  Subcommand smooth_command = add("smooth", "Take a hand's tremor, keep the path", smoothTrajectory);
  Subcommand retime_command = add("retime", "New times along the same path", retimeTrajectory);
  Subcommand check_command = add("check", "Limits and collisions along the whole motion", check);
  Subcommand export_command = add("export", "Write it in another format or as a robot's program", exportTrajectory);

  addTrajectoryEdits(command, chosen);
  addTrajectoryTraining(command, chosen);

  for (Subcommand sub : {simplify_command, smooth_command, retime_command}) {
    sub.option("-o,--output", options->output, "The result: .htraj, .json or .csv").takes(ValueKind::kMotion);
    addAllowMiss(sub, options->allow_miss);
  }
  addAllowMiss(export_command, options->allow_miss);
  for (Subcommand sub : {info_command, smooth_command}) {
    sub.option("--robot", options->limits.robot,
               "Robot whose joints they are, for poses by its forward kinematics: a file or library:NAME")
        .takes(ValueKind::kRobot);
  }
  retime_command.option("--tolerance", options->passing, "How near each given frame is passed, m (0.00005)");
  retime_command.option("--angle-tolerance", options->angle_passing, "Likewise its turn, or each joint, rad (0.0002)");
  addTolerance(simplify_command, *options);
  addTolerance(smooth_command, *options);
  retime_command.option("--mode", options->mode, "time-optimal (default) or constant-speed");
  retime_command.option("--speed", options->speed, "m/s, for constant-speed (0.1)");
  retime_command.option("--sample", options->sample, "Time between the frames of the result, s (0.01)");
  addLimits(retime_command, options->limits);
  addCheckOptions(check_command, options->check);
  for (Subcommand sub : {smooth_command, retime_command}) {
    sub.option("--workcell", options->check.workcell,
               "The cell to move through: nearer to the recording where it would collide")
        .takes(ValueKind::kWorkcell);
    sub.option("--entity", options->check.entity, "What moves (as the trajectory says)");
  }

  export_command.option("--to", options->to, "csv, json, ros, krl, rapid, fanuc, urscript, val3 or inform").required();
  export_command.option("-o,--output", options->output, "The file; a folder for val3")
      .takes(ValueKind::kMotion)
      .required();
  export_command.option("--name", options->program.name, "The program's name (of the file)");
  export_command.option("--tool", options->program.tool,
                        "The controller's tool: its name; a number for fanuc and inform");
  export_command.option("--base", options->program.base, "The controller's base, work object or user frame, likewise");
  export_command.option("--speed", options->program.speed, "m/s along lines (0.25)");
  export_command.option("--acceleration", options->program.acceleration, "m/s2 along lines (1.2)");
  export_command.option("--joint-speed", options->program.joint_speed, "Share of the first move's speed (0.2)");
  export_command.option("--blend", options->program.blend, "m (0.002)");
  export_command
      .option("--robot", options->limits.robot,
              "Robot for configuration data, joints, and poses where the file has none: a file or library:NAME")
      .takes(ValueKind::kRobot);
}

}  // namespace hapticell::cli
