// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/set_slots.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

namespace {

// Half and twice of both pass the tests of this folder.
constexpr double kOldestAge = 1.0;   // s that a moving obstacle is foreseen.
constexpr double kOrderLasts = 2.5;  // s that a set's number shuts lower ones out.

}  // namespace

void SetSlots::reset() {
  has_set_ = offered_ = false;
  since_change_ = 0.0;
}

void SetSlots::advance(double dt) {
  since_change_ += dt;
  sets_[current_].age = std::min(sets_[current_].age + dt, kOldestAge);
}

bool SetSlots::isOutdated(std::uint64_t sequence) const {
  return has_set_ && since_change_ < kOrderLasts && sequence < current().sequence;
}

void SetSlots::offer(const ConstraintSet& set, double age) {
  sets_[1 - current_].take(set);
  offerNext(age);
}

void SetSlots::offer(const GroupedSet& set, double age) {
  sets_[1 - current_] = set;
  offerNext(age);
}

void SetSlots::offerNext(double age) {
  sets_[1 - current_].age = std::isfinite(age) ? std::clamp(age, 0.0, kOldestAge) : 0.0;
  offered_ = true;
}

void SetSlots::change() {
  current_ = 1 - current_;
  has_set_ = true;
  offered_ = false;
  since_change_ = 0.0;
}

}  // namespace hapticell::haptic
