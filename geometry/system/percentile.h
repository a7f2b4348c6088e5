// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace hapticell {

/// The value below which `share` (0 to 1) of the values lie, by the nearest rank; 0 if there are no values. The values
/// need no order.
inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const double last = static_cast<double>(values.size() - 1);
  const auto rank = values.begin() + std::lround(std::clamp(share, 0.0, 1.0) * last);
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

}  // namespace hapticell
