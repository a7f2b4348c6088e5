// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "manipulation/checks/inverse_batch.h"

namespace hapticell::studies {

/// Greatest speed and acceleration of each variable of a robot.
struct JointRates {
  std::vector<double> speed, acceleration;  ///< rad/s (m/s), rad/s2.
};

/// Speeds as the robot's file has them; accelerations so that each joint reaches its speed in `time_to_speed` s.
JointRates jointRates(const kinematics::RobotModel& model, double time_to_speed);

/// The least time (s) of the straight motion from rest to rest between two joint positions.
double straightTime(const JointRates& rates, const std::vector<double>& from, const std::vector<double>& to);

/// A way through all targets in their order.
struct CycleRoute {
  std::vector<const manipulation::FreeSolution*> stops;  ///< The solution taken at each target.
  double time_s = 0.0;                                   ///< Of all motions, without waiting.
  int changes = 0;                                       ///< Neighbours whose configurations differ.
};

/// The route of least time from `start` through one free solution of each target, and back to `start` if `returns`: by
/// dynamic programming, so it is the best of all choices. Empty stops: a target has none.
CycleRoute fastestRoute(const JointRates& rates, const std::vector<double>& start,
                        const std::vector<manipulation::FreeAnswer>& targets, bool returns);

}  // namespace hapticell::studies
