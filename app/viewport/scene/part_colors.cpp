// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/part_colors.h"

#include <atomic>

#include "app/viewport/scene/render_item.h"

namespace hapticell::app {
namespace {

std::atomic<bool> full_colors = false;

}  // namespace

bool fullColorsNow() {
  return full_colors;
}

void setFullColorsNow(bool full) {
  full_colors = full;
}

std::array<float, 3> partColor(const std::array<float, 3>& own) {
  return full_colors ? own : quietened(own);
}

}  // namespace hapticell::app
