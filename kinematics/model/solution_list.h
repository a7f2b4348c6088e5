// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "kinematics/model/configuration_flags.h"
#include "kinematics/model/inverse_model.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// One way to bring the tip to a pose, as a list to choose from shows it.
struct ListedSolution {
  std::vector<double> q;  ///< One a variable of the model; those that do not move the tip keep their present positions.
  bool within_limits = false;
  Text reason;                ///< Empty, or why it is out: "A5 would be 12.3 deg over its upper limit".
  int limiting_joint = -1;    ///< Index among the model's joints of the worst one; -1 where none is over.
  std::string configuration;  ///< "front, elbow up, wrist not flipped"; see configurationName().
  std::string maker_flags;    ///< "S 2, T 35" and the like; empty where the maker or the shape is unknown.
  double distance = 0.0;      ///< From now: the largest joint motion, rad (a slide's metre counts as a radian).
  double time_s = 0.0;        ///< The same with each joint at its greatest speed.
  bool is_now = false;        ///< The robot already has these positions (within 1e-6).
};

struct SolutionListOptions {
  bool with_turns = false;        ///< Also each solution within limits with joints turned by full turns.
  std::size_t most_turns = 1024;  ///< Of turned ones for a pose, nearest first.
};

/// All solutions for the tip at X_BT, nearest to `q_now` first: those within limits, then the others with the reason.
///
/// Collisions are the caller's to check; for a chain with more than six variables the list is a sample of the
/// infinitely many. `inverse` must be for a chain of `model`.
std::vector<ListedSolution> listSolutions(const RobotModel& model, const InverseModel& inverse, const Pose& X_BT,
                                          const std::vector<double>& q_now, const SolutionListOptions& options = {});

}  // namespace hapticell::kinematics
