// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// A 6 x dof matrix, row-major: rows 0-2 linear (m/s), rows 3-5 angular (rad/s), one column per variable of the model.
struct Jacobian {
  std::size_t columns = 0;
  std::vector<double> values;  ///< 6 * columns numbers.

  double operator()(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
  double& operator()(std::size_t row, std::size_t column) { return values[row * columns + column]; }
};

/// A dof x 6 matrix, row-major: the effect of each variable for a motion of a point (columns 0-2 linear, 3-5 angular).
struct InverseJacobian {
  std::size_t rows = 0;
  std::vector<double> values;  ///< 6 * rows numbers.

  double operator()(std::size_t row, std::size_t column) const { return values[row * 6 + column]; }
  double& operator()(std::size_t row, std::size_t column) { return values[row * 6 + column]; }
};

/// Indices of the joints from the root to `link`, base first, including fixed ones.
std::vector<int> chainToTip(const RobotModel& model, int link);

/// Indices of the variables that move `link` (by joints or by mimic joints on its chain), from base to tip.
std::vector<int> variablesOfChain(const RobotModel& model, int link);

/// The geometric Jacobian of the point Q fixed on `link`: V_BQ = J * qdot, expressed in the root link's frame B.
///
/// `X_BL` are the link poses from forwardKinematics() at the same joint positions; `p_BQ` is the present position of
/// the point, in B. Mimic joints contribute to the variable they follow. `J` is resized (no allocation once it has its
/// size).
void geometricJacobian(const RobotModel& model, const std::vector<Pose>& X_BL, int link, const dvec3& p_BQ,
                       Jacobian& J);

/// How close a Jacobian is to a singularity; lengths are divided by a lever (m) to make both kinds of rows comparable.
struct Manipulability {
  double smallest = 0.0;  ///< The least of the min(6, columns that move it) singular values.
  double largest = 0.0;
  double measure = 0.0;  ///< Product of the singular values (Yoshikawa 1985).
  bool singular() const { return smallest < 1e-3; }
};
Manipulability manipulability(const Jacobian& J, double lever_m);

/// The damped pseudo-inverse J+ = Jᵀ (J Jᵀ + λ² I)⁻¹ with the rows scaled by `lever_m` (Nakamura and Hanafusa 1986).
///
/// λ is zero while the least singular value σ (linear rows divided by the lever) is above `threshold`, and grows to it
/// at the singularity, λ² = threshold² - σ², so that no singular value of J+ exceeds 1 / threshold. With fewer than six
/// variables, directions that no variable moves are ignored. `out` is resized.
void dampedPseudoInverse(const Jacobian& J, double lever_m, double threshold, InverseJacobian& out);

/// The remaining motion of a variable to its limit, rad or m; negative if it is outside; infinite without a limit.
struct LimitDistance {
  double to_lower = 0.0;
  double to_upper = 0.0;
};
std::vector<LimitDistance> limitDistances(const RobotModel& model, const std::vector<double>& q);

}  // namespace hapticell::kinematics
