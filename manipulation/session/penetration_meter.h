// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// Measures how deep the shown entity is in anything, by exact distance queries of its own that share nothing with the
/// engine but the meshes.
class PenetrationMeter {
 public:
  /// Depth of the held entity now, m: 0 when it is free; else an upper bound (the shortest translation found that frees
  /// it).
  double measure(const ManipulationEngine& engine);
  double worst() const { return worst_; }
  /// Of pairs that must not pass through each other.
  double worstBlocked() const { return worst_blocked_; }

 private:
  double worst_ = 0.0, worst_blocked_ = 0.0, last_ = 0.0;
  workcell::EntityId measured_id_ = 0;
  EntityConfiguration measured_;
};

}  // namespace hapticell::manipulation
