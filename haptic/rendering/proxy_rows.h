// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/entry_rows.h"

namespace hapticell::haptic {

/// A constraint set as the force loop reads it: its entries number by number, and the group number of each. Whoever
/// receives a set makes it, so that the force loop only copies it. Does not allocate; about 24 kB.
struct GroupedSet {
  std::uint64_t sequence = 0;
  std::int64_t stamp_ns = 0;
  Pose X_DR;
  double zone_radius = kWantedZoneRadius;
  std::size_t count = 0;
  std::array<std::uint8_t, kMaxConstraints> row_of{};
  std::size_t groups = 0;
  bool each_alone = true;   ///< Each entry is a group of its own, and none a pull.
  bool well_formed = true;  ///< Of the set that was prepared last; if not, the rest is that of the one before.
  double age = 0.0;         ///< s since the set was made; its moving obstacles have moved for this time.
  EntryArrays arrays;       ///< Of the set's entries.

  /// Takes a set from outside if it is well-formed.
  void prepare(const ConstraintSet& wanted);
  /// Takes a well-formed set and numbers its groups.
  void take(const ConstraintSet& wanted);
  /// Force of the entries of kind kPull on a stylus at X_DS, N; bounded.
  dvec3 pullAt(const Pose& X_DS) const;
  /// xi relative to the obstacle, which has moved since the set was made.
  Vector6 seenFrom(std::size_t entry, const Vector6& xi) const;
};

/// The share of a set's zone in which the proxy is kept and new sets are adopted: half a percent lets the proxy move
/// along the edge. A margin of half leaves less for rounding and Newton's step, of twice takes 1 % of each zone.
inline constexpr double kTrustedShare = 0.995;

/// The half-spaces of one set around one proxy pose: one row per group, from the group's freest entry, and last the
/// trust row, which keeps the proxy inside the set's zone.
struct ProxyRows {
  EntryRows row;                               ///< Without lengths.
  std::array<std::uint8_t, kMaxRows> entry{};  ///< The entry from which each group's row was made.
  Vector6 from_reference{};                    ///< Of the pose, in the metric.

  void gather(const GroupedSet& grouped, const Pose& X_DP);

  /// True if, within a micrometre, the proxy is also on another entry of a group than the freest one; either entry is
  /// then valid for the group.
  bool tied() const { return tied_count_ > 0; }
  /// Chooses in tied groups the entry that blocks `wanted` (in the metric, m) least, given what else holds the proxy.
  /// If nothing else holds it, the freest entry stays. Example: a proxy slides from one body onto another that is flush
  /// with it. It is equally free by the second body's top and by its hidden side. The top blocks nothing that the first
  /// body's top has not already stopped; only the side would be felt. An entry with a trim is never chosen this way:
  /// its row is one of the two half-spaces that bound it, and the roof over one ridge would lead past its end into the
  /// next tooth.
  void settle(const Vector6& wanted);

 private:
  void gatherEach(const GroupedSet& grouped, const Vector6& xi);
  void gatherFreest(const GroupedSet& grouped, const Vector6& xi);
  void noteTouched(const GroupedSet& grouped, std::size_t index);
  void addTrustRow(double zone_radius);
  void countTied();

  /// An entry that the proxy is on.
  struct Touched {
    std::uint8_t slot = 0, entry = 0;
  };
  EntryRows made_;  ///< Of all entries, where groups have several.
  std::array<Touched, kMaxConstraints> touched_;
  std::size_t touched_count_ = 0;
  std::array<bool, kMaxRows> is_tied_{};
  std::size_t tied_count_ = 0;
};

}  // namespace hapticell::haptic
