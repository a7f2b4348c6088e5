// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QRectF>

class QPainter;
class QPainterPath;

namespace hapticell::app {

struct Theme;

/// Fills a path with a colour and a score's pattern: 0 plain, 1 hatched, 2 cross-hatched in a darker tone of it.
void fillWithPattern(QPainter& painter, const QPainterPath& path, const QColor& color, int pattern);

/// A patch in the colour and pattern of a score's band, 0 to 3.
void paintBand(QPainter& painter, const QRectF& area, int band, const Theme& theme);

}  // namespace hapticell::app
