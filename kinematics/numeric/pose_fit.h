// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// Parameters of one descent of fitPose().
struct FitOptions {
  double lever = 0.25;  ///< m: an orientation error of 1 rad weighs as much as this position error.
  int max_iterations = 40;
  /// Uses the curvature of the residual if the residual cannot vanish (out of reach, at limits).
  bool second_order = true;
  bool give_up_when_slow = false;  ///< For restarts: stop after four consecutive steps with little progress.
};

/// The box that the variables must stay in.
struct FitBox {
  ChainPositions lower{};
  ChainPositions upper{};
};

struct FitResult {
  ChainPositions x{};
  double position_error = 0.0;     ///< m
  double orientation_error = 0.0;  ///< rad
  bool converged = false;          ///< Both within 1e-9.
  bool held = false;               ///< Not converged, and a bound of the box is active.
  int iterations = 0;
};

/// Least squares of |p* - p|² + (lever |log(R* Rᵀ)|)² over the chain's variables inside a box, from `x_start` (moved
/// into the box): Levenberg-Marquardt with an active set of bounds; each descent ends at a minimum or the iteration
/// limit.
///
/// A variable on a bound is fixed while the gradient points outward and released when it points inward; a variable
/// whose step would cross its bound is set to the bound and the others are solved again. The damping follows the error
/// and the gain ratio (Nielsen 1999). If the error hardly decreases, the exact Hessian replaces JᵀJ as long as it is
/// positive definite, so that a pose out of reach is approached in a few steps instead of hundreds. No allocation, no
/// exception. `arm`: the same chain as from trueArm(), for at most seven joints; it is several times as fast. Null: any
/// chain.
FitResult fitPose(const Chain& chain, const Pose& X_BT, const ChainPositions& x_start, const FitBox& box,
                  const FitOptions& options, const kernels::TrueArm* arm = nullptr);

}  // namespace hapticell::kinematics
