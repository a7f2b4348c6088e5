// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/frame_colors.h"

namespace hapticell::app {
namespace {

fvec3 rgb(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}
glm::vec4 rgba(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
}

}  // namespace

FrameColors frameColors(const Theme& theme, const std::vector<workcell::PairSet>& sets) {
  FrameColors colors;
  colors.background_top = rgb(theme.scene.background_top);
  colors.background_bottom = rgb(theme.scene.background_bottom);
  colors.grid = rgba(theme.scene.grid);
  colors.crease = rgba(theme.scene.crease);
  colors.selected = rgb(theme.selection);
  colors.hovered = rgb(theme.text2);
  colors.near_miss = rgb(theme.near_miss);
  colors.contact = rgb(theme.contact);
  colors.floor_shadow = theme.dark ? 0.42f : 0.20f;
  colors.set_colors.fill({colors.contact, colors.near_miss});
  const auto take = [](const std::optional<std::array<float, 3>>& own, fvec3& color) {
    if (own) color = {(*own)[0], (*own)[1], (*own)[2]};
  };
  for (std::size_t i = 0; i < sets.size() && i + 1 < kSetColors; ++i) {
    take(sets[i].contact_color, colors.set_colors[i + 1].contact);
    take(sets[i].near_miss_color, colors.set_colors[i + 1].near_miss);
  }
  return colors;
}

}  // namespace hapticell::app
