// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "haptic/rendering/constraint_set.h"

namespace hapticell::haptic {

/// The rows of a solver number by number, so that one vector instruction takes several rows. For the force loop.
struct RowArrays {
  /// Rows of the solver (kMaxRows), up to the next multiple of a vector's lanes.
  static constexpr std::size_t kMost = (kMaxConstraints + 2 + 3) / 4 * 4;
  alignas(64) double normal[6][kMost];
  double slack[kMost];
  double both_ways[kMost];  ///< 1 for an equality, which is violated to both sides; else 0.
  double barred[kMost];     ///< Infinity for a row that is left out, as those are that fill the last vector; else 0.
  std::size_t count = 0;    ///< A multiple of four.
};

/// Of the rows that are left by more than `tolerance` (m) at `d` the one that is left by most, the first of equal ones;
/// false: no row is left by so much. By the widest vector instructions of this processor; the same to the last bit on
/// all of them. Never allocates.
bool mostViolated(const RowArrays& rows, const Vector6& d, double tolerance, std::size_t& row) noexcept;

/// The same by what every processor has; for tests.
bool mostViolatedPortably(const RowArrays& rows, const Vector6& d, double tolerance, std::size_t& row) noexcept;

}  // namespace hapticell::haptic
