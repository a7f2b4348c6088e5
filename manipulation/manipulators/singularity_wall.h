// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::manipulation {

/// Singular positions of a serial arm as a wall: the least singular value of the tool centre point's Jacobian, lengths
/// over `lever_m`, must not fall under kWall. For a wrist it is about the angle (rad) from the singular position.
class SingularityWall {
 public:
  /// Least singular value; of a wrist about the rad (1.1 deg) from its singular position. Our choice. Half: joints turn
  /// twice as fast at it; twice: 2.3 deg of each wrist are lost.
  static constexpr double kWall = 0.02;
  /// The felt wall is a fifth before the hard one, so that a hand slides along it. Half of that: the hard one blocks
  /// first, which sticks; twice: more is lost.
  static constexpr double kFelt = 0.024;

  /// `model` is kept by reference and has no closure (contract).
  SingularityWall(const kinematics::RobotModel& model, int tip_link, const Pose& X_LT, double lever_m);

  double measure(const std::vector<double>& q) const;
  /// d measure / dq, by central differences.
  std::vector<double> gradient(const std::vector<double>& q) const;
  /// The largest s in [0, 1] of the straight motion up to which the wall is not passed; a motion that begins behind it
  /// must only get no nearer to the singularity.
  double freeShare(const std::vector<double>& from, const std::vector<double>& to) const;

 private:
  const kinematics::RobotModel& model_;
  int tip_link_;
  Pose X_LT_;
  double lever_m_;
};

}  // namespace hapticell::manipulation
