// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

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

/// Rows number by number, so that one vector instruction takes several rows. For the force loop.
struct RowArrays {
  /// kMaxRows, up to the next multiple of a vector's lanes.
  static constexpr std::size_t kMost = (kMaxRows + 3) / 4 * 4;
  alignas(64) double normal[6][kMost];
  double slack[kMost];
  double both_ways[kMost];  ///< 1 for an equality, which is violated to both sides; else 0.
  std::size_t count = 0;

  Vector6 normalOf(std::size_t i) const;
  SolverRow at(std::size_t i) const { return {normalOf(i), slack[i], both_ways[i] != 0.0}; }
  void put(std::size_t i, const SolverRow& row);
  /// Appends; there must be room.
  void add(const SolverRow& row) { put(count++, row); }
  /// Fills the last vector with rows that nothing violates; needed before a search, `count` stays.
  void fillLastVector();
};

/// Of the rows that are left by more than `tolerance` (m) at `d` the one that is left by most, the first of equal ones;
/// false: no row is left by so much. `barred`: infinity for a row that is left out, else 0, kMost numbers. By the
/// widest vector instructions of this processor; the same to the last bit on all of them. Never allocates.
bool mostViolated(const RowArrays& rows, const double* barred, const Vector6& d, double tolerance,
                  std::size_t& row) noexcept;

/// The same by what every processor has; for tests.
bool mostViolatedPortably(const RowArrays& rows, const double* barred, const Vector6& d, double tolerance,
                          std::size_t& row) noexcept;

}  // namespace hapticell::haptic
