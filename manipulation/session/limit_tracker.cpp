// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/limit_tracker.h"

#include <algorithm>

namespace hapticell::manipulation {

void LimitTracker::add(double t, const ManipulationEngine& engine) {
  const double interruption = std::max(kInterruption, 2.5 * (t - t_before_));  // A slow loop looks rarely.
  t_before_ = t;
  open_.endOlder(t, interruption);
  for (const LimitState& limit : engine.nearLimits()) {
    if (!limit.holds) continue;
    const auto [interval, begins] = open_.see({limit.kind, limit.joint}, t);
    if (begins) {
      interval.data = limits_.size();
      limits_.push_back({english(limit.text), limit.kind, limit.joint, t, t});
    }
    limits_[interval.data].time_out = t;
  }
}

}  // namespace hapticell::manipulation
