// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "trajectory/editing/segment_distance.h"

namespace hapticell::trajectory {

/// Splits spans of frames at the frame that deviates most from the straight segment between the ends, until no
/// deviation is greater than 1. The split frames are added to `kept`, which is sorted at the end (Douglas & Peucker,
/// Cartographica 10(2), 1973). `off(i, span)` returns the deviation of frame i.
template <typename Off>
void splitAtFarthest(std::vector<FrameSpan> open, const Off& off, std::vector<std::size_t>& kept) {
  while (!open.empty()) {
    const FrameSpan span = open.back();
    open.pop_back();
    double worst = 1.0;
    std::size_t at = 0;
    for (std::size_t i = span.first + 1; i < span.last; ++i) {
      const double share = off(i, span);
      if (share <= worst) continue;
      worst = share;
      at = i;
    }
    if (at == 0) continue;
    kept.push_back(at);
    open.push_back({span.first, at});
    open.push_back({at, span.last});
  }
  std::sort(kept.begin(), kept.end());
}

}  // namespace hapticell::trajectory
