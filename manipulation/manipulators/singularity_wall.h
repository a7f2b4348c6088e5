// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::manipulation {

/// Singularities of a serial arm as a wall: the least singular value of the tool centre point's Jacobian, with lengths
/// divided by `lever_m`, must not fall below kWall. For a wrist it is about the angle (rad) from the singularity.
class SingularityWall {
 public:
  /// Least singular value; for a wrist about the angle in rad (1.1 deg) from its singularity. Our choice. Half: joints
  /// turn twice as fast there; twice: 2.3 deg of each wrist are lost.
  static constexpr double kWall = 0.02;
  /// The felt wall is a fifth before the hard one, so that a hand slides along it. Half of that distance: the hard wall
  /// blocks first, which sticks; twice: more of the workspace is lost.
  static constexpr double kFelt = 0.024;

  /// `model` is kept by reference and has no closure (contract).
  SingularityWall(const kinematics::RobotModel& model, int tip_link, const Pose& X_LT, double lever_m);

  double measure(const std::vector<double>& q) const;
  /// d measure / dq, by central differences.
  std::vector<double> gradient(const std::vector<double>& q) const;
  /// The largest s in [0, 1] up to which the straight motion does not pass the wall; a motion that begins behind the
  /// wall must only get no nearer to the singularity.
  double freeShare(const std::vector<double>& from, const std::vector<double>& to) const;

 private:
  const kinematics::RobotModel& model_;
  int tip_link_;
  Pose X_LT_;
  double lever_m_;
};

}  // namespace hapticell::manipulation
