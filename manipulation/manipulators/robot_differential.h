// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "manipulation/manipulators/part_differential.h"

namespace hapticell::manipulation {

/// How a robot that is dragged by its tool centre point follows it, to second order: motions of its links and joints
/// for a small motion xi of the TCP (see PartDifferential).
struct RobotDifferential {
  std::vector<PartDifferential> links;                     ///< One per link of the model.
  std::vector<std::array<double, 6>> joint_velocity;       ///< dq_i / dxi: row i of the damped J+.
  std::vector<std::array<double, 21>> joint_acceleration;  ///< Bilinear second-order term of q_i, packed.

  /// The nearest edge of the workspace, where the arm is stretched or folded: f = edge.gap + edge.gradient . xi >= 0.
  bool has_edge = false;
  haptic::Constraint edge;

  /// For a robot with a closure: limits and singularities of its passive joints, to first order.
  struct Margin {
    kinematics::ClosureMargin at;
    haptic::Constraint constraint;
  };
  std::vector<Margin> margins;
};

/// Differentiates at joint positions `q` (one per variable), with the root link at X_WB and the TCP at X_LT in link
/// `tip`.
///
/// The inverse of the 6 x n Jacobian is damped below a singular value of 0.02 (rotation weighted with
/// haptic::kRotationLever): near a singularity, joints then stay slow, as in the inverse model (Wampler 1986, Nakamura
/// and Hanafusa 1986). Second order: J q'' = -J' q' along each direction and its polarisation. The edge of the
/// workspace is derived from a small singular value s with left and right vectors u, v: the motion u . x(t) = s t + c
/// t^2 / 2 along v reverses at -s/c, so the boundary is s^2 / (2 |c|) away along u.
RobotDifferential differentiateRobot(const kinematics::RobotModel& model, const std::vector<double>& q,
                                     const Pose& X_WB, int tip, const Pose& X_LT);

}  // namespace hapticell::manipulation
