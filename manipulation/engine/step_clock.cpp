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
  /// s that a step stands for: of a stalled machine the slowest loop's (10 Hz), and a tenth of the fastest. Half of the
  /// first: joints at 10 Hz are half as fast; twice: leaps.
  constexpr double kLongest = 0.1, kShortest = 1e-4;
  return std::clamp(1e-9 * static_cast<double>(now_ns_ - last_step_ns_), kShortest, kLongest);
}

}  // namespace hapticell::manipulation
