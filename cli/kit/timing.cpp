// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/timing.h"

#include <algorithm>
#include <cmath>

namespace hapticell::cli {

nlohmann::ordered_json Timing::toJson() const {
  std::vector<double> sorted = durations_us_;
  std::sort(sorted.begin(), sorted.end());
  const auto rank = [&](double share) {
    if (sorted.empty()) return 0.0;
    const auto nearest = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::clamp<std::size_t>(nearest, 1, sorted.size()) - 1];
  };
  return {{"median_us", rank(0.5)}, {"p99_us", rank(0.99)}, {"max_us", rank(1.0)}};
}

}  // namespace hapticell::cli
