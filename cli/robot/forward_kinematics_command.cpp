// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "cli/kit/robot_options.h"
#include "cli/robot/robot_commands.h"
#include "trajectory/files/pose_csv.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct ForwardOptions {
  std::string robot;
  std::string joints;
  std::string tip;
  AxisOptions axes;
};

ordered_json poseToJson(const Pose& X) {
  return {{"x", X.p.x}, {"y", X.p.y}, {"z", X.p.z}, {"qw", X.q.w}, {"qx", X.q.x}, {"qy", X.q.y}, {"qz", X.q.z}};
}

Expected<ordered_json> solve(const ForwardOptions& options) {
  auto robot = readRobotWithTip(options.robot, options.tip, workcell::RobotContent::kKinematics);
  HAPTICELL_TRY(robot);
  HAPTICELL_TRY(addExternalAxes(options.axes, *robot));
  const auto rows = trajectory::readJointCsv(options.joints, robot->jointNames());
  HAPTICELL_TRY(rows);
  ordered_json poses = ordered_json::array();
  std::vector<double> q(robot->model.dof(), 0.0);  // joints that do not move the tip stay at zero
  std::vector<Pose> X_BL;
  for (const std::vector<double>& row : *rows) {
    for (std::size_t i = 0; i < row.size(); ++i) q[static_cast<std::size_t>(robot->variables[i])] = row[i];
    kinematics::forwardKinematics(robot->model, q, X_BL);
    poses.push_back(poseToJson(X_BL[static_cast<std::size_t>(robot->tip)]));
  }
  return ordered_json{{"root", robot->model.links[0].name},
                      {"tip", robot->model.links[static_cast<std::size_t>(robot->tip)].name},
                      {"joint_names", robot->jointNames()},
                      {"poses", std::move(poses)}};
}

}  // namespace

void addForwardKinematicsCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("fk", "Compute poses of a robot's tip in its root link from joint positions");
  const auto options = std::make_shared<ForwardOptions>();
  command.option("--robot", options->robot, "Robot: a file, or library:NAME").takes(ValueKind::kRobot).required();
  command
      .option("--joints", options->joints, "CSV with one column per joint, by name, for all joints that move the tip")
      .takes(ValueKind::kTable)
      .required();
  command.option("--tip", options->tip, "Link of the tip (default: the tool or the end of the arm)");
  command.option("--on", options->axes.on, "External axes that carry the robot: FILE[,link=L][,pose=x,y,z,qw,qx,qy,qz]")
      .takes(ValueKind::kRobot);
  command
      .option("--part-on", options->axes.part_on,
              "The same for the positioner that carries the part: poses are then in its link, and pose is its own")
      .takes(ValueKind::kRobot);
  command.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      const auto result = solve(*options);
      const auto written = result ? writer.write(*result) : Expected<void>(tl::unexpected<Error>(result.error()));
      if (!written) report(written.error());
      return written ? ExitStatus::kDone : ExitStatus::kBadInput;
    };
  });
}

}  // namespace hapticell::cli
