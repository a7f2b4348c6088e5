// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/overlay/overlay_painter.h"

namespace hapticell::app {

/// A stylus's number at the upper end of its pen.
struct PenTag {
  int number = 1;  ///< 1 or 2, as in the panel.
  QRectF box;      ///< Pixels at 100 %, inside the viewport.
};

/// Both tags while two styluses are connected, else empty. If they would overlap, the second one moves.
std::vector<PenTag> penTags(const Overlay& overlay);

void paintPenTags(QPainter& painter, const Overlay& overlay);

}  // namespace hapticell::app
