// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/motion_file.h"

#include <memory>

#include "cli/kit/result_writer.h"
#include "cli/kit/robot_options.h"
#include "exchange/recordings/recording_reader.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::cli {

Expected<trajectory::ProgramReadOptions> programReadOptions(const std::string& robot) {
  trajectory::ProgramReadOptions options;
  if (robot.empty()) return options;
  auto read = readRobotWithTip(robot, "", workcell::RobotContent::kKinematics);
  HAPTICELL_TRY(read);
  if (read->variables.size() != 6) {
    return makeError({.file = robot,
                      .place = "joints",
                      .found = std::to_string(read->variables.size()),
                      .expected = "a robot of six joints"});
  }
  options.joint_names = read->jointNames();
  options.forward_kinematics = [shared = std::make_shared<const RobotWithTip>(std::move(*read))](
                                   std::span<const double> joints) -> std::optional<Pose> {
    if (joints.size() != shared->variables.size()) return std::nullopt;
    std::vector<double> q(shared->model.dof(), 0.0);
    for (std::size_t i = 0; i < joints.size(); ++i) q[static_cast<std::size_t>(shared->variables[i])] = joints[i];
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(shared->model, q, X_BL);
    return X_BL[static_cast<std::size_t>(shared->tip)];
  };
  return options;
}

Expected<trajectory::Trajectory> readMotionFile(const std::string& file, const std::string& robot,
                                                std::vector<Text>* notes) {
  std::vector<Text> told;
  std::vector<Text>& into = notes ? *notes : told;
  Expected<trajectory::Trajectory> motion = trajectory::Trajectory{};
  if (!robot.empty() && trajectory::isProgramFile(file)) {
    const auto options = programReadOptions(robot);
    HAPTICELL_TRY(options);
    auto program = trajectory::readProgram(file, *options);
    HAPTICELL_TRY(program);
    into.insert(into.end(), program->notes.begin(), program->notes.end());
    motion = std::move(program->trajectory);
  } else if (exchange::isMcapFile(file)) {
    motion = exchange::readMcapMotion(file, {}, &into);
  } else {
    motion = trajectory::readTrajectory(file, &into);
  }
  for (const Text& note : told) warn(english(note));
  return motion;
}

}  // namespace hapticell::cli
