// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/render_item.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

/// Luma as Rec. 601 weighs the components.
float brightness(const std::array<float, 3>& color) {
  return 0.299f * color[0] + 0.587f * color[1] + 0.114f * color[2];
}

}  // namespace

std::array<float, 3> quietened(const std::array<float, 3>& color, float limit) {
  const float high = std::max({color[0], color[1], color[2]});
  const float low = std::min({color[0], color[1], color[2]});
  if (high <= 0.0f) return color;
  const float saturation = (high - low) / high;
  if (saturation <= limit) return color;
  const float share = limit / saturation;
  std::array<float, 3> quiet{};
  for (std::size_t i = 0; i < 3; ++i) quiet[i] = high - (high - color[i]) * share;
  // Half way to as bright as it was: at the same greatest component an orange becomes a light pink, at the same
  // brightness a brown.
  const float darker = std::sqrt(brightness(color) / brightness(quiet));
  for (float& component : quiet) component *= darker;
  return quiet;
}

}  // namespace hapticell::app
