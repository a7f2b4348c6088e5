// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::haptic {

/// A constraint set with the row that each of its entries competes for. For the force loop: nothing allocates.
struct GroupedSet {
  ConstraintSet set;
  std::array<std::uint8_t, kMaxConstraints> row_of{};
  std::size_t groups = 0;
  double age = 0.0;  ///< s since the set was made: so far its moving obstacles have gone.

  /// Copies a well-formed set (only the entries that it has) and numbers its groups.
  void take(const ConstraintSet& wanted);
  /// What the entries of kind kPull do to a stylus at X_DS, N; bounded.
  dvec3 pullAt(const Pose& X_DS) const;
  /// xi as it is seen from an obstacle that has moved since.
  Vector6 seenFrom(std::size_t entry, const Vector6& xi) const;
};

/// The part of a set's zone in which the proxy is kept and new sets are taken: inside the very edge, which it never
/// leaves, there is room to go round along it.
inline constexpr double kTrustedShare = 0.995;

/// The half-spaces of one set about one proxy pose: one row a group, from the group's entry that is freest, and the
/// trust row last, which keeps the proxy inside the set's zone.
struct ProxyRows {
  std::array<SolverRow, kMaxRows> row;
  std::array<std::uint8_t, kMaxRows> entry{};  ///< The entry that each group's row comes from.
  std::size_t count = 0;

  std::span<const SolverRow> all() const { return {row.data(), count}; }
  void gather(const GroupedSet& grouped, const Pose& X_DP);

 private:
  void offer(std::size_t slot, std::size_t index, const Constraint& constraint, const Vector6& xi);
  void addTrustRow(const ConstraintSet& set, const Vector6& from_reference);
};

}  // namespace hapticell::haptic
