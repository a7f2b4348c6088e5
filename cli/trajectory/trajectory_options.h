// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/trajectory/trajectory_check.h"
#include "cli/trajectory/trajectory_robot.h"
#include "trajectory/programs/writing/program_export.h"

namespace hapticell::cli {

/// Options of the commands that take one motion.
struct TrajectoryOptions {
  std::string file;
  std::string output;
  double tolerance = 0.001;
  double angle_tolerance = 0.017453292519943295;
  double joint_tolerance = 0.0;                 ///< 0: the turn that moves a tool at 1 m by `tolerance`.
  double passing = 5e-5, angle_passing = 2e-4;  ///< For retime.
  bool allow_miss = false;
  std::string mode = "time-optimal";
  double speed = 0.1;
  double sample = 0.01;
  RobotLimitOptions limits;
  std::string to;
  trajectory::ProgramOptions program;
  TrajectoryCheckOptions check;
  std::vector<Text> notes;  ///< From reading the file.
};

}  // namespace hapticell::cli
