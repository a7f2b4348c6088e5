// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "kinematics/model/configuration_flags.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// One solution for a pose of the tip, for a list to choose from.
struct ListedSolution {
  /// One per variable of the model; those that do not move the tip keep their present positions.
  std::vector<double> q;
  bool within_limits = false;
  Text reason;  ///< Empty, or why it is out: "A5 would be 12.3 deg over its upper limit".
  /// Index of the joint that exceeds its limit most, among the model's joints; -1 if none does.
  int limiting_joint = -1;
  std::string configuration;  ///< "front, elbow up, wrist not flipped"; see configurationName().
  std::string maker_flags;    ///< "S 2, T 35" and the like; empty where the maker or the shape is unknown.
  /// From the present position: the largest joint motion, rad (a metre of a slide counts as a radian).
  double distance = 0.0;
  double time_s = 0.0;  ///< The same with each joint at its greatest speed.
  bool is_now = false;  ///< The robot is already at these positions (within 1e-6).
};

struct SolutionListOptions {
  bool with_turns = false;        ///< Also list each solution within limits with joints turned by full turns.
  std::size_t most_turns = 1024;  ///< Of turned solutions per pose, nearest first.
};

/// All solutions for the tip at X_BT, nearest to `q_now` first: those within limits, then the others with the reason.
///
/// The caller must check collisions. For a chain with more than six variables, the list is a sample of the infinitely
/// many. `inverse` must be for a chain of `model`.
std::vector<ListedSolution> listSolutions(const RobotModel& model, const InverseModel& inverse, const Pose& X_BT,
                                          const std::vector<double>& q_now, const SolutionListOptions& options = {});

}  // namespace hapticell::kinematics
