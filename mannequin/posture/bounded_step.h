// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "mannequin/posture/body_state.h"

namespace hapticell::mannequin {

/// Rows of the whole-body task: feet 2 x 6, centre of mass 2, hands 2 x 6. An unused row has zeros and a regularisation
/// of 1.
inline constexpr int kTaskRows = 26;
inline constexpr int kFootRow = 0, kBalanceRow = 12, kHandRow = 14;

/// min |dq - dqc|^2_D + |J dq - e|^2_(1/R)  subject to  lower <= dq <= upper.
struct StepProblem {
  std::array<std::array<double, kTaskRows>, kVariables> J{};  ///< By columns.
  std::array<double, kTaskRows> e{};
  std::array<double, kTaskRows> R{};
  Variables D{};
  Variables wish{};  ///< dqc: has an effect in directions that the tasks leave free.
  Variables lower{}, upper{};
  /// For a held object: the columns of the left arm extend into the rows of the right hand.
  bool arms_coupled = false;
};

/// The active bound of a variable: -1 lower, +1 upper, 0 free. Reusing it from step to step saves passes.
using ActiveSet = std::array<std::int8_t, kVariables>;

/// Solves it exactly: Newton steps on the dual function (kTaskRows unknowns), which is concave and made of parabolas,
/// each cut where that function is highest along it (a semismooth Newton method with exact line search, for example
/// Hintermueller, Ito and Kunisch, SIAM J. Optim. 13, 2003); usually 1 to 5, at most 32, after which the bounds still
/// hold but the objective may not be least. `active` is the first guess and becomes what was found. No allocation.
void solveStep(const StepProblem& problem, ActiveSet& active, Variables& step);

}  // namespace hapticell::mannequin
