// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "bench/thread_clock.h"

namespace hapticell::bench {

inline constexpr int kWalks = 3;

struct Times {
  double median_us = 0.0, p99_us = 0.0, max_us = 0.0;
};

/// Walks the path several times from a fresh state; each step's time is the least of its walks (takes the system's
/// noise out and keeps the engine's own spikes); processor time, the clock's own cost taken off. `begin_walk` forgets
/// what was warm.
inline Times timed(std::size_t steps, const std::function<void()>& begin_walk,
                   const std::function<void(std::size_t)>& query) {
  std::vector<double> least(steps, std::numeric_limits<double>::infinity());
  const double clock_cost = threadClockCost();
  for (int walk = 0; walk < kWalks; ++walk) {
    begin_walk();
    for (std::size_t i = 0; i < steps; ++i) {
      const double begin = threadMilliseconds();
      query(i);
      least[i] = std::min(least[i], 1e3 * std::max(0.0, threadMilliseconds() - begin - clock_cost));
    }
  }
  std::sort(least.begin(), least.end());
  return {least[least.size() / 2], least[least.size() * 99 / 100], least.back()};
}

}  // namespace hapticell::bench
