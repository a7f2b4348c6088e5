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

  /// True where the proxy is on another entry of a group, to a micrometre, than the freest one: as far as this group
  /// goes, each of them would do.
  bool tied() const { return tied_count_ > 0; }
  /// Takes in tied groups the entry that is least in the way of `wanted` (in the metric, m) as far as what else holds
  /// the proxy lets it go; where nothing else holds it, the freest stays. A proxy that slides from one body onto
  /// another one, flush with it, is as free of that one by its top as by its hidden side: the top is in the way of
  /// nothing that the first body's top has not stopped, and only the side would be felt. An entry with a trim is never
  /// taken so: its row is one of the two half-spaces that bound it, and the roof over one ridge would lead past its end
  /// into the next tooth.
  void settle(const Vector6& wanted);

 private:
  void offer(std::size_t slot, std::size_t index, const Constraint& constraint, const Vector6& xi);
  void addTrustRow(const ConstraintSet& set, const Vector6& from_reference);
  void countTied();

  /// An entry that the proxy is on.
  struct Touched {
    SolverRow row;
    std::uint8_t slot = 0, entry = 0;
  };
  std::array<Touched, kMaxConstraints> touched_;
  std::size_t touched_count_ = 0;
  std::array<bool, kMaxRows> is_tied_{};
  std::size_t tied_count_ = 0;
};

}  // namespace hapticell::haptic
