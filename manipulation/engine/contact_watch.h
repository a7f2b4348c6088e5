// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

/// Finds the pairs of the entity held by a stylus that are at their boundary, and when the newest contact was first
/// felt. Manipulation thread only.
class ContactWatch {
 public:
  /// Call it if another entity or none is held, or if the hand moves without the entity.
  void clear();
  /// Updates the contacts of the held entity, with the stylus (or proxy) at X_DP and the newest set; a new contact was
  /// felt at `felt_ns`.
  void look(HeldEntity& held, const BuiltConstraints& built, const Pose& X_DP, std::int64_t now_ns,
            std::int64_t felt_ns);

  /// Indices into HeldEntity::pairs().
  const std::vector<std::size_t>& contacts() const { return contacts_; }
  bool isInContact(std::size_t pair) const;
  /// ns; 0 before the first contact.
  std::int64_t feltAt() const { return felt_ns_; }

 private:
  void lookAtPassed(HeldEntity& held, std::int64_t now_ns);

  std::vector<double> gaps_;
  std::vector<std::size_t> contacts_;
  std::int64_t felt_ns_ = 0;
  std::int64_t passed_ns_ = -1;
  std::vector<std::size_t> passed_;  // Touching pairs in mode *Pass*; checked from time to time.
};

}  // namespace hapticell::manipulation
