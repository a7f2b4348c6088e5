// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/force_extremes.h"

#include <algorithm>

namespace hapticell::manipulation {

void ForceExtremes::add(const MeteredTick& tick) {
  max_force_ = std::max(max_force_, glm::length(tick.force_D));
  if (started_) {
    const double ms = std::max(1e-6, 1e3 * (tick.t - last_.t));
    max_step_ = std::max(max_step_, glm::length(tick.force_D - last_.force_D) / std::max(1.0, ms));
    max_pull_step_ = std::max(max_pull_step_, glm::length(tick.pull_D - last_.pull_D) / std::max(1.0, ms));
    energy_.add(tick.step_D, last_.coupling_D, tick.stiffness);
    energy_.note(tick.t);
  }
  started_ = true;
  last_ = tick;
}

}  // namespace hapticell::manipulation
