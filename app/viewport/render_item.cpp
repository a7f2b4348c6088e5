// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/render_item.h"

#include <algorithm>

namespace hapticell::app {

std::array<float, 3> quietened(const std::array<float, 3>& color, float limit) {
  const float high = std::max({color[0], color[1], color[2]});
  const float low = std::min({color[0], color[1], color[2]});
  if (high <= 0.0f) return color;
  const float saturation = (high - low) / high;
  if (saturation <= limit) return color;
  const float share = limit / saturation;
  return {high - (high - color[0]) * share, high - (high - color[1]) * share, high - (high - color[2]) * share};
}

}  // namespace hapticell::app
