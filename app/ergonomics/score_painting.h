// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRectF>
#include <vector>

#include "app/style/pattern.h"
#include "app/style/theme.h"
#include "app/viewport/scene/render_item.h"

class QPainter;

namespace hapticell::app {

/// The look of a body segment in this band.
LinkLook lookOf(int band, const Theme& theme);

/// One row of coloured pieces; `bands` are equally long, -1 leaves a gap.
void paintStrip(QPainter& painter, const QRectF& area, const std::vector<int>& bands, const Theme& theme);

}  // namespace hapticell::app
