// SPDX-License-Identifier: Apache-2.0
#include "app/style/pattern.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/style/theme.h"

namespace hapticell::app {

void fillWithPattern(QPainter& painter, const QPainterPath& path, const QColor& color, int pattern) {
  painter.fillPath(path, color);
  if (pattern <= 0) return;
  painter.save();
  painter.setClipPath(path, Qt::IntersectClip);
  const QRectF box = path.boundingRect();
  painter.setPen(QPen(color.darker(220), 1.3));
  constexpr double kStep = 5.0;
  for (double x = box.left() - box.height(); x < box.right(); x += kStep) {
    painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    if (pattern > 1) painter.drawLine(QPointF(x, box.top()), QPointF(x + box.height(), box.bottom()));
  }
  painter.restore();
}

void paintBand(QPainter& painter, const QRectF& area, int band, const Theme& theme) {
  const int place = std::clamp(band, 0, 3);
  QPainterPath path;
  path.addRoundedRect(area, 2, 2);
  fillWithPattern(painter, path, theme.score[static_cast<std::size_t>(place)], place < 2 ? 0 : place - 1);
}

}  // namespace hapticell::app
