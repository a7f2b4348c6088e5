// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/overlay/label_layout.h"
#include "app/viewport/overlay/overlay_labels.h"

namespace hapticell::app {

// Text boxes over the scene: labels with their leaders, and strips of values. Pixels at 100 %; GUI thread.

/// Size of a label's box for layout.
QSizeF labelSize(const OverlayLabel& label);
void paintLabel(QPainter& painter, const OverlayLabel& label, const PlacedLabel& place, const Theme& theme);

/// Strips above each other, the first at the bottom.
using Strips = std::vector<std::vector<StripCell>>;
/// The bounding box of all strips in the viewport; empty without strips.
QRectF stripsBox(const Strips& strips, const ViewSize& size);
void paintStrips(QPainter& painter, const Strips& strips, const ViewSize& size, const Theme& theme);

/// The mark of a state, the same everywhere: a filled diamond, an open triangle, an H.
void paintMark(QPainter& painter, Mark mark, const QPointF& center, double size, const Theme& theme);
QColor markColor(Mark mark, const Theme& theme);

/// The background of text over the scene.
void paintBox(QPainter& painter, const QRectF& box, const Theme& theme);
/// A line on top of its halo.
void haloLine(QPainter& painter, const QPolygonF& line, const QColor& color, double width, const QColor& halo);

QPointF point(const glm::dvec2& p);
QFont bold15();
double textWidth(const QFont& text_font, const QString& text);

}  // namespace hapticell::app
