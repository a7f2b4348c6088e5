// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/score_painting.h"
#include "app/style/style_painting.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace hapticell::app {

LinkLook lookOf(int band, const Theme& theme) {
  const int place = std::clamp(band, 0, 3);
  const QColor& color = theme.score[static_cast<std::size_t>(place)];
  return {channelsOf(color),
          static_cast<std::uint8_t>(place < 2 ? 0 : place - 1)};
}

void paintStrip(QPainter& painter, const QRectF& area, const std::vector<int>& bands, const Theme& theme) {
  if (bands.empty()) return;
  const double width = area.width() / static_cast<double>(bands.size());
  for (std::size_t first = 0; first < bands.size();) {
    std::size_t last = first;
    while (last < bands.size() && bands[last] == bands[first]) ++last;
    const QRectF piece(area.left() + width * static_cast<double>(first), area.top(),
                       width * static_cast<double>(last - first), area.height());
    if (bands[first] >= 0) {
      QPainterPath path;
      path.addRect(piece);
      const int place = std::clamp(bands[first], 0, 3);
      fillWithPattern(painter, path, theme.score[static_cast<std::size_t>(place)], place < 2 ? 0 : place - 1);
      painter.setPen(QPen(theme.window, 1));
      painter.drawLine(piece.topRight(), piece.bottomRight());
    } else {
      painter.setPen(QPen(theme.line, 1, Qt::DashLine));
      painter.drawLine(QPointF(piece.left(), piece.center().y()), QPointF(piece.right(), piece.center().y()));
    }
    first = last;
  }
}

}  // namespace hapticell::app
