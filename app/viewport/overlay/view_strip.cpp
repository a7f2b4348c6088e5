// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/view_strip.h"

#include <cmath>

#include "app/style/fonts.h"

namespace hapticell::app {
namespace {

constexpr double kLeft = 10.0, kTop = 10.0, kHeight = 26.0;
constexpr double kPadding = 12.0, kArrowRoom = 20.0;

double widthOf(const ViewStripCell& cell) {
  return std::ceil(2.0 * kPadding + QFontMetricsF(textFont(TextRole::kText)).horizontalAdvance(cell.text) + kArrowRoom);
}

}  // namespace

QRectF ViewStrip::cellBox(std::size_t cell) const {
  double x = kLeft;
  for (std::size_t i = 0; i < cell; ++i) x += widthOf(cells_[i]);
  return {x, kTop, widthOf(cells_[cell]), kHeight};
}

QRectF ViewStrip::box() const {
  QRectF box;
  for (std::size_t i = 0; i < cells_.size(); ++i) box = box.united(cellBox(i));
  return box;
}

int ViewStrip::cellAt(const QPointF& place) const {
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (cellBox(i).contains(place)) return static_cast<int>(i);
  return -1;
}

void ViewStrip::paint(QPainter& painter, const Theme& theme, int hovered) const {
  if (cells_.empty()) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.scene.label_box);
  painter.drawRoundedRect(box(), 4, 4);
  painter.setFont(textFont(TextRole::kText));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const QRectF cell = cellBox(i);
    if (static_cast<int>(i) == hovered) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme.button);
      painter.drawRoundedRect(cell, 4, 4);
    }
    if (i > 0) {
      painter.setPen(QPen(theme.line, 1.0));
      painter.drawLine(cell.topLeft() + QPointF(0.5, 6), cell.bottomLeft() + QPointF(0.5, -6));
    }
    painter.setPen(theme.text1);
    painter.drawText(cell.adjusted(kPadding, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, cells_[i].text);
    painter.setPen(QPen(theme.text2, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF c(cell.right() - kPadding - 4, cell.center().y() + 0.5);
    painter.drawPolyline(QPolygonF({c + QPointF(-4, -2), c + QPointF(0, 2), c + QPointF(4, -2)}));
  }
}

}  // namespace hapticell::app
