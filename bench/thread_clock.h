// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

namespace hapticell::bench {

/// Processor time of the calling thread, ms: other programs' time slices are out.
inline double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// What reading that clock costs by itself, ms.
inline double threadClockCost() {
  double least = 1.0;
  for (int i = 0; i < 1000; ++i) {
    const double begin = threadMilliseconds();
    const double cost = threadMilliseconds() - begin;
    if (cost < least) least = cost;
  }
  return least;
}

}  // namespace hapticell::bench
