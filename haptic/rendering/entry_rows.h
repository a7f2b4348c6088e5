// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/violated_rows.h"

namespace hapticell::haptic {

/// A set's entries number by number for all entries: one vector instruction takes the same number of several entries.
/// Filled by GroupedSet::take().
struct EntryArrays {
  alignas(64) double gap[kMaxConstraints];
  double gradient[6][kMaxConstraints];
  double curvature[21][kMaxConstraints];
  double velocity[3][kMaxConstraints];
  double trim_gap[kMaxConstraints];  ///< An entry without a trim has one that is zero everywhere.
  double trim_gradient[6][kMaxConstraints];
  double stiffness[kMaxConstraints], damping[kMaxConstraints], friction[kMaxConstraints], reach[kMaxConstraints];
  std::uint64_t pulls = 0, equalities = 0, trims = 0;  ///< A bit for each entry of the kind, or with a trim.
  bool any_trim = false;                               ///< Else the trims' numbers are not filled.
  std::size_t count = 0;  ///< Of entries, up to the next multiple of a vector's lanes; those beyond the set's are zero.

  void take(const ConstraintSet& set);
  dvec3 velocityOf(std::size_t i) const { return {velocity[0][i], velocity[1][i], velocity[2][i]}; }
  /// An entry's gap, gradient and curvature; nothing else of it.
  Constraint surfaceOf(std::size_t i) const;
  static bool has(std::uint64_t bits, std::size_t entry) { return (bits >> entry & 1u) != 0; }
};

static_assert(kMaxConstraints <= 64, "a bit for each entry");

/// The half-spaces of all entries around one pose: their normals in the proxy's metric and their slacks, m. makeRows()
/// fills these and the lengths only, up to a multiple of a vector's lanes.
struct EntryRows : RowArrays {
  alignas(64) double length[kMaxConstraints];  ///< Of the gradient in the metric; below kLeastSlope: no row.
};

/// Of a gradient that has no direction to be felt in. Half and twice pass the tests of this folder.
inline constexpr double kLeastSlope = 1e-9;

/// The rows at the displacement `xi` from the set's reference pose, `age` seconds after the set was made, by the widest
/// vector instructions of this processor; the same to the last bit on all of them. Never allocates; for the force loop.
void makeRows(const EntryArrays& entries, const Vector6& xi, double age, EntryRows& rows) noexcept;

/// The same by what every processor has; for tests.
void makeRowsPortably(const EntryArrays& entries, const Vector6& xi, double age, EntryRows& rows) noexcept;

}  // namespace hapticell::haptic
