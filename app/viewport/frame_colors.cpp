// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/frame_colors.h"

namespace hapticell::app {
namespace {

fvec3 rgb(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}
glm::vec4 rgba(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
}

}  // namespace

FrameColors frameColors(const Theme& theme) {
  FrameColors colors;
  colors.background_top = rgb(theme.background_top);
  colors.background_bottom = rgb(theme.background_bottom);
  colors.grid = rgba(theme.grid);
  colors.crease = rgba(theme.crease);
  colors.selected = rgb(theme.selection);
  colors.hovered = rgb(theme.text2);
  colors.near_miss = rgb(theme.near_miss);
  colors.contact = rgb(theme.contact);
  colors.floor_shadow = theme.dark ? 0.42f : 0.20f;
  return colors;
}

}  // namespace hapticell::app
