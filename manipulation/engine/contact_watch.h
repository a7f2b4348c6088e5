// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// Which pairs of what a stylus holds are at their boundary, and when the newest of them was felt first. The
/// manipulation thread's.
class ContactWatch {
 public:
  /// Something else is held, or nothing, or it is not moved.
  void clear();
  /// Looks at what is held, with the stylus (or proxy) at X_DP and the newest set; a contact that is new was felt at
  /// `felt_ns`.
  void look(HeldEntity& held, const BuiltConstraints& built, const Pose& X_DP, std::int64_t now_ns,
            std::int64_t felt_ns);

  /// Indices into HeldEntity::pairs().
  const std::vector<std::size_t>& contacts() const { return contacts_; }
  bool isInContact(std::size_t pair) const;
  /// ns; 0 before any.
  std::int64_t feltAt() const { return felt_ns_; }

 private:
  void lookAtPassed(HeldEntity& held, std::int64_t now_ns);

  std::vector<double> gaps_;
  std::vector<std::size_t> contacts_;
  std::int64_t felt_ns_ = 0;
  std::int64_t passed_ns_ = -1;
  std::vector<std::size_t> passed_;  // Pairs that pass through each other and touch; looked at now and then.
};

}  // namespace hapticell::manipulation
