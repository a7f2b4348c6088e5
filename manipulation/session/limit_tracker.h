// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/session/interval_tracker.h"

namespace hapticell::manipulation {

/// A limit that held the entity for a while.
struct LimitInterval {
  std::string text;  ///< At the beginning.
  LimitKind kind = LimitKind::kJoint;
  int joint = -1;
  double time_in = 0.0, time_out = 0.0;
};

/// Which limits held the entity, and when. Interruptions of kInterruption or two steps do not end an interval.
class LimitTracker {
 public:
  void add(double t, const ManipulationEngine& engine);
  const std::vector<LimitInterval>& limits() const { return limits_; }

 private:
  std::vector<LimitInterval> limits_;
  IntervalTracker<std::pair<LimitKind, int>, std::size_t> open_;  // Data: index into limits_.
  double t_before_ = 0.0;
};

}  // namespace hapticell::manipulation
