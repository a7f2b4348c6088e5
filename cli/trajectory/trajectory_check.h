// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/kit/subcommand.h"
#include "geometry/system/error.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/timing/retiming.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::cli {

struct TrajectoryCheckOptions {
  std::string workcell;
  std::string entity;  ///< Empty: as named in the trajectory.
  std::string moved_by;
  std::vector<std::string> together;  ///< Files of motions on the same clock: those of the axes that carry the robot.
  bool fail_on_contact = false;
  bool fail_on_limit = false;
};

void addCheckOptions(Subcommand command, TrajectoryCheckOptions& options);

/// Checks the motion in the workcell. The field `found` is true if there is a finding that the options ask to fail on.
Expected<nlohmann::ordered_json> checkTrajectory(const trajectory::Trajectory& trajectory,
                                                 const TrajectoryCheckOptions& options);

/// A processed motion that stays closer to its recording where it would collide in the workcell, with a robot's joints
/// computed for its poses; and what was done.
struct KeptFreeResult {
  trajectory::Trajectory trajectory;
  nlohmann::ordered_json report;
  trajectory_checks::PosesByJoints poses_by_joints{};  ///< Of the cell's entity, if it is a robot.
};
Expected<KeptFreeResult> keepFree(const trajectory::Trajectory& recording, trajectory::Trajectory processed,
                                  const TrajectoryCheckOptions& options);

/// Computes new times for a motion, kept free in the same way; the report also has what `retime` reports.
Expected<KeptFreeResult> retimeFree(const trajectory::Trajectory& given, const trajectory::RetimingOptions& retiming,
                                    const TrajectoryCheckOptions& options, trajectory::RetimingReport& report);

}  // namespace hapticell::cli
