// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {

/// The constraint set in use and the one offered last, until the next tick changes them.
///
/// Force loop's thread; never allocates, locks or throws. About 50 kB.
class SetSlots {
 public:
  /// Forgets both.
  void reset();
  /// Ages the set in use by `dt` s.
  void advance(double dt);

  /// Whether a set with this number is older than the one in use and that one was adopted within the last 2.5 s.
  bool isOutdated(std::uint64_t sequence) const;
  /// `age` (s, limited to 1): how long ago the set was made.
  void offer(const ConstraintSet& set, double age);
  void offer(const GroupedSet& set, double age);
  /// Puts the offered set into use.
  void change();

  bool holds() const { return has_set_; }
  bool offered() const { return offered_; }
  const GroupedSet& current() const { return sets_[current_]; }
  const GroupedSet& next() const { return sets_[1 - current_]; }  ///< The offered one.
  std::uint64_t sequence() const { return has_set_ ? current().sequence : 0; }

 private:
  void offerNext(double age);

  std::array<GroupedSet, 2> sets_{};
  std::size_t current_ = 0;  ///< Index of the set in use; the other one is the offered one.
  bool has_set_ = false;
  bool offered_ = false;
  double since_change_ = 0.0;  ///< s.
};

}  // namespace hapticell::haptic
