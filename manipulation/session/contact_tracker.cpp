// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/contact_tracker.h"

#include <algorithm>

namespace hapticell::manipulation {

void ContactTracker::add(double t, const ManipulationEngine& engine, double force) {
  if (const HeldEntity* held = engine.held()) {
    for (const std::size_t i : engine.contacts()) {
      const HeldPair& pair = held->pairs()[i];
      const auto [interval, begins] = open_.see({held->id(), pair.other}, t);
      if (begins) {
        interval.data = contacts_.size();
        // Of what it carries the carried entity's name stands for the part.
        const bool own = pair.owner == held->id();
        const std::string& part = own ? pair.moved_part : engine.scene()->find(pair.owner)->name;
        contacts_.push_back({held->id(), pair.other, part, pair.other_part, t, t, 0.0});
      }
      ContactInterval& contact = contacts_[interval.data];
      contact.time_out = t;
      const bool passes = pair.on_contact == workcell::OnContact::kPass;
      contact.max_force = std::max(contact.max_force, passes ? 0.0 : force);
    }
  }
  open_.endOlder(t, kInterruption);
}

void ContactTracker::finish(double t) {
  open_.endAll([&](const auto& interval) { contacts_[interval.data].time_out = t; });
}

}  // namespace hapticell::manipulation
