// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <random>
#include <string_view>

#include "mannequin/body/joint_limits.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// A random orientation of a ball joint inside `share` of its limits.
inline dmat3 randomBall(std::mt19937_64& random, BallJoint joint, Side side, double share) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double psi = 2.0 * std::numbers::pi * unit(random) - std::numbers::pi;
  const double limit = ballState(joint, side, ballRotation(joint, side, 0.2, psi, 0.0)).rho_max;
  const double twist =
      twistLower(joint) + (0.5 + share * (unit(random) - 0.5)) * (twistUpper(joint) - twistLower(joint));
  return ballRotation(joint, side, share * limit * std::sqrt(unit(random)), psi, twist);
}

/// Uniform within `share` of all limits about their middles; the root anywhere near the origin.
inline Posture randomPosture(std::mt19937_64& random, double share = 1.0) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  Posture posture;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    posture.angles[i] = 0.5 * (info.lower + info.upper) + share * unit(random) * (info.upper - info.lower);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    setBallRotation(posture, armDof(side, Dof::kLeftShoulderFlexion),
                    randomBall(random, BallJoint::kShoulder, side, share));
    setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), randomBall(random, BallJoint::kHip, side, share));
  }
  posture.X_WR.p = {unit(random), unit(random), 1.0 + unit(random)};
  posture.X_WR.q = quaternionFromRotationVector({unit(random), unit(random), 6.0 * unit(random)});
  return posture;
}

}  // namespace hapticell::mannequin
