// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "haptic/rendering/constraint_set.h"

namespace hapticell::haptic {

/// One row per constraint (at most one per group), the trust row and one spare.
inline constexpr std::size_t kMaxRows = kMaxConstraints + 2;

/// A half-space of the proxy's small motion d: normal . d >= -slack (an equality: = -slack).
///
/// d = (translation, kRotationLever * rotation vector), metres; the normal has unit length.
/// Its numbers are not set by itself: a tick makes hundreds of rows.
struct SolverRow {
  Vector6 normal;
  double slack;  ///< Metres that are free along -normal; negative when the row is violated at d = 0.
  bool equality;
};

enum class SolverStatus : std::uint8_t {
  kSolved,      ///< Every row is satisfied; d is the nearest such motion.
  kInfeasible,  ///< The rows contradict each other: d is the middle between them (least squares).
  kGaveUp,      ///< The step limit was reached; d is the last iterate, nearer to feasible than d0.
};

struct SolverResult {
  SolverStatus status = SolverStatus::kSolved;
  Vector6 d{};
  std::size_t active_count = 0;
  std::array<double, kMaxRows> multiplier{};  ///< d - d0 = sum of multiplier[i] * row[i].normal; 0 for inactive rows.
};

/// The motion nearest to `d0` inside all rows: min 1/2 |d - d0|^2 subject to them.
///
/// A dual active-set method for strictly convex quadratic programmes (D. Goldfarb, A. Idnani, "A numerically stable
/// dual method for solving strictly convex quadratic programs", Mathematical Programming 27, 1983) with the identity as
/// Hessian. The dual is regularised by 1e-7, so contradicting rows give their middle, and it stops after two dependent
/// rows. At most kMaxRows rows (more are ignored). Never allocates or throws; for the force loop.
SolverResult nearestFeasible(std::span<const SolverRow> rows, const Vector6& d0) noexcept;

/// The same for a proxy that must never enter anything. If rows contradict each other, those satisfied at d = 0 stay
/// satisfied, and the others get no deeper than the deepest of them already is. Within these limits d is nearest to the
/// middle. `multiplier` still gives d - d0.
SolverResult nearestUnentered(std::span<const SolverRow> rows, const Vector6& d0) noexcept;

}  // namespace hapticell::haptic
