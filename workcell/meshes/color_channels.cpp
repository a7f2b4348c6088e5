// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/color_channels.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hapticell::workcell {

void ColorChannels::set(std::size_t index, const std::array<double, 3>& channels) {
  // Guards sums of channels; real ones are 255 or 65535 at most. Half, twice: no effect.
  constexpr double kMost = 1e6;
  const auto usable = [](double channel) { return channel >= 0.0 && channel <= kMost; };  // False for NaN too.
  if (!std::all_of(channels.begin(), channels.end(), usable)) {
    ++refused_;
    return;
  }
  if (channels_.size() <= index) channels_.resize(index + 1, kNoColor);
  for (std::size_t k = 0; k < 3; ++k) {
    channels_[index][k] = static_cast<float>(channels[k]);
    greatest_ = std::max(greatest_, channels_[index][k]);
  }
}

std::vector<Color> ColorChannels::take(std::size_t count, std::optional<double> full) && {
  if (channels_.empty()) return {};
  channels_.resize(count, kNoColor);
  const float guessed = greatest_ > 1.0f ? 255.0f : 1.0f;
  const float whole = full ? static_cast<float>(*full) : guessed;
  for (Color& color : channels_) {
    if (!isColor(color)) continue;
    for (float& channel : color) channel = std::min(channel / whole, 1.0f);
  }
  return std::move(channels_);
}

void ColorChannels::report(Of of, Diagnostics& diagnostics) const {
  if (refused_ == 0) return;
  diagnostics.warn(
      of == Of::kVertices
          ? Text("%1 vertices have an invalid colour (expected numbers, 0 or more); it was left out", refused_)
          : Text("%1 faces have an invalid colour (expected numbers, 0 or more); it was left out", refused_));
}

Color meanColor(std::span<const Color> colors) {
  if (!std::all_of(colors.begin(), colors.end(), isColor)) return kNoColor;
  if (std::all_of(colors.begin(), colors.end(), [&](const Color& c) { return c == colors.front(); }))
    return colors.front();
  Color mean{0.0f, 0.0f, 0.0f};
  for (const Color& color : colors) {
    for (std::size_t k = 0; k < 3; ++k) mean[k] += color[k] / static_cast<float>(colors.size());
  }
  for (float& channel : mean) channel = std::min(channel, 1.0f);  // Rounded, ten tenths are more than one.
  return mean;
}

}  // namespace hapticell::workcell
