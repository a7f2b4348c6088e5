// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/step_clock.h"

#include <algorithm>

namespace hapticell::manipulation {

void StepClock::tick(std::int64_t now_ns) {
  if (steps_ == 0) start_ns_ = now_ns_ = now_ns;
  last_step_ns_ = now_ns_;
  now_ns_ = now_ns;
  ++steps_;
}

double StepClock::sinceStart() const {
  return steps_ == 0 ? 0.0 : 1e-9 * static_cast<double>(now_ns_ - start_ns_);
}

double StepClock::stepTime() const {
  constexpr double kLongest = 0.1, kShortest = 1e-4;  // s
  return std::clamp(1e-9 * static_cast<double>(now_ns_ - last_step_ns_), kShortest, kLongest);
}

}  // namespace hapticell::manipulation
