// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::manipulation {

/// Motion of the links of a robot with a closure, by its variables, to second order; and its margins, to first order.
///
/// By central differences of the closure's forward model (h = 1e-4 rad or m): n (n + 1) evaluations. Link k's origin
/// moves by sum_i velocity(i, k) dq_i + 1/2 sum_ij acceleration(i, j, k) dq_i dq_j and its rotation vector likewise.
class ClosureJets {
 public:
  /// Computes them at `q`; poses in W, for the root link at X_WB.
  ClosureJets(const kinematics::RobotModel& model, const std::vector<double>& q, const Pose& X_WB);

  std::size_t links() const { return X_WL_.size(); }
  const std::vector<Pose>& poses() const { return X_WL_; }
  const Twist& velocity(std::size_t variable, std::size_t link) const { return velocity_[variable * links() + link]; }
  const Twist& acceleration(std::size_t i, std::size_t j, std::size_t link) const {
    return acceleration_[(i * variables_ + j) * links() + link];
  }

  /// A margin of the closure with its gradient over the variables.
  struct Margin {
    kinematics::ClosureMargin at;
    std::vector<double> gradient;
  };
  const std::vector<Margin>& margins() const { return margins_; }

 private:
  std::size_t variables_ = 0;
  std::vector<Pose> X_WL_;
  std::vector<Twist> velocity_, acceleration_;
  std::vector<Margin> margins_;
};

}  // namespace hapticell::manipulation
