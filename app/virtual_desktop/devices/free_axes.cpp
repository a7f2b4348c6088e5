// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/free_axes.h"

namespace hapticell::app {

FreeAxes afterKey(const FreeAxes& now, std::size_t axis) {
  FreeAxes only_moving, only_turning;
  only_moving.moves = only_moving.turns = only_turning.moves = only_turning.turns = {false, false, false};
  only_moving.moves[axis] = only_turning.turns[axis] = true;
  if (now == only_moving) return only_turning;
  if (now == only_turning) return {};
  return only_moving;
}

std::string freeAxesText(const FreeAxes& axes) {
  std::string text;
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(i < 3 ? axes.moves[i] : axes.turns[i - 3])) continue;
    if (!text.empty()) text += ' ';
    text += "XYZABC"[i];
  }
  return text.empty() ? "none" : text;
}

}  // namespace hapticell::app
