// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/session/interval_tracker.h"

namespace hapticell::manipulation {

/// One contact of two entities.
struct ContactInterval {
  workcell::EntityId entity = 0;
  workcell::EntityId other = 0;
  std::string moved_part, other_part;
  double time_in = 0.0, time_out = 0.0;
  double max_force = 0.0;
};

/// Which entities touched, when, and with what force.
class ContactTracker {
 public:
  void add(double t, const ManipulationEngine& engine, double force);
  /// Ends the present contacts at `t`.
  void finish(double t);
  const std::vector<ContactInterval>& contacts() const { return contacts_; }

 private:
  std::vector<ContactInterval> contacts_;
  IntervalTracker<std::pair<workcell::EntityId, workcell::EntityId>, std::size_t> open_;  // Data: index into contacts_.
};

}  // namespace hapticell::manipulation
