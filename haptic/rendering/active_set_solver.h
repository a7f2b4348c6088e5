// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "haptic/rendering/violated_rows.h"

namespace hapticell::haptic {

enum class SolverStatus : std::uint8_t {
  kSolved,      ///< Every row is satisfied; d is the nearest such motion.
  kInfeasible,  ///< The rows contradict each other: d is the middle between them (least squares).
  kGaveUp,      ///< The step limit was reached; d is the last iterate, nearer to feasible than d0.
};

/// Rows that held a motion back.
struct ActiveRows {
  static constexpr std::size_t kMost = 8;  ///< Six independent rows and two dependent ones.
  std::array<std::uint8_t, kMost> row{};
  std::size_t count = 0;
};

struct SolverResult {
  SolverStatus status = SolverStatus::kSolved;
  Vector6 d{};
  std::size_t active_count = 0;
  ActiveRows active;                          ///< As many as active_count if kSolved, else none.
  std::array<double, kMaxRows> multiplier{};  ///< d - d0 = sum of multiplier[i] * row[i].normal; 0 for inactive rows.
};

/// The motion nearest to `d0` inside all rows: min 1/2 |d - d0|^2 subject to them.
///
/// A dual active-set method for strictly convex quadratic programmes (D. Goldfarb, A. Idnani, "A numerically stable
/// dual method for solving strictly convex quadratic programs", Mathematical Programming 27, 1983) with the identity as
/// Hessian. The dual is regularised by 1e-7, so contradicting rows give their middle, and it stops after two dependent
/// rows. At most kMaxRows rows (more are ignored). Never allocates or throws; for the force loop.
///
/// `begin_with`: rows that may hold this motion back, as those of the last motion do; the answer is the same with any
/// (to 1e-7 m), but found in one step where they are right. `rows` must have had fillLastVector().
SolverResult nearestFeasible(const RowArrays& rows, const Vector6& d0, const ActiveRows& begin_with = {}) noexcept;
SolverResult nearestFeasible(std::span<const SolverRow> rows, const Vector6& d0) noexcept;

/// The same for a proxy that must never enter anything. If rows contradict each other, those satisfied at d = 0 stay
/// satisfied, and the others get no deeper than the deepest of them already is. Within these limits d is nearest to the
/// middle. `multiplier` still gives d - d0.
SolverResult nearestUnentered(const RowArrays& rows, const Vector6& d0, const ActiveRows& begin_with = {}) noexcept;
SolverResult nearestUnentered(std::span<const SolverRow> rows, const Vector6& d0) noexcept;

}  // namespace hapticell::haptic
