// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// How far and how fast one joint of a held entity moved.
struct JointUse {
  int joint = -1;  ///< Index among the robot's joints.
  double lowest = 0.0, highest = 0.0;
  double max_speed = 0.0;       ///< rad/s or m/s, from one step to the next.
  double greatest_speed = 0.0;  ///< The joint's limit.
};

/// Follows the joints of the held entity from step to step.
class JointMeter {
 public:
  void add(double t, const ManipulationEngine& engine);
  const std::vector<JointUse>& joints() const { return joints_; }

 private:
  std::vector<JointUse> joints_;
  std::vector<double> before_;
  double t_before_ = 0.0;
  workcell::EntityId id_ = 0;
};

}  // namespace hapticell::manipulation
