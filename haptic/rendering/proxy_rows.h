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
/// trust row last, which keeps the proxy inside the set's zone. Of entries that are as free as the freest, within kTie,
/// the one counts that the wish goes against least: where two bodies lie flush, a proxy that slides from one to the
/// other is as free by the top of the second as by its hidden side, and only the side would stop it.
struct ProxyRows {
  std::array<SolverRow, kMaxRows> row;
  std::array<std::uint8_t, kMaxRows> entry{};  ///< The entry that each group's row comes from.
  std::size_t count = 0;

  std::span<const SolverRow> all() const { return {row.data(), count}; }
  /// `wish` in the proxy's metric, m: where it would go next, no farther than one move of it.
  void gather(const GroupedSet& grouped, const Pose& X_DP, const Vector6& wish = {});
  static constexpr double kTie =
      0.0;  ///< m: equal to the last bit only. (With 1e-6 seams are smooth, but a rack is entered.)

 private:
  /// An entry's row, and how free the wish would leave it.
  struct Offer {
    SolverRow row;
    double ahead = 0.0;
  };
  bool beats(const Offer& offer, std::size_t slot) const;
  void offer(std::size_t slot, std::size_t index, const Constraint& constraint, const Vector6& xi, const Vector6& wish);
  void addTrustRow(const ConstraintSet& set, const Vector6& from_reference);

  std::array<double, kMaxRows> ahead_{};   ///< Of the entry that each group's row comes from,
  std::array<double, kMaxRows> freest_{};  ///< and the slack of its freest one.
};

}  // namespace hapticell::haptic
