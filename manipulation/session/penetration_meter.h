// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// Measures how deep the shown entity penetrates others, by its own exact distance queries, which share only the meshes
/// with the engine.
class PenetrationMeter {
 public:
  /// Present depth of the held entity, m: 0 if it is free; else an upper bound (the shortest translation found that
  /// frees it).
  double measure(const ManipulationEngine& engine);
  double worst() const { return worst_; }
  /// For pairs that must not pass through each other.
  double worstBlocked() const { return worst_blocked_; }

 private:
  double worst_ = 0.0, worst_blocked_ = 0.0, last_ = 0.0;
  workcell::EntityId measured_id_ = 0;
  EntityConfiguration measured_;
};

}  // namespace hapticell::manipulation
