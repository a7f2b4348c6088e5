// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/overlay_boxes.h"

#include <cmath>

#include "app/style/fonts.h"
#include "app/style/pattern.h"

namespace hapticell::app {
namespace {

constexpr double kStripHeight = 42.0, kStripGap = 6.0;
constexpr double kCellPadding = 14.0;
constexpr double kBesideNumber = 8.0;

/// Where a label's number begins: after its mark or patch.
double indentOf(const OverlayLabel& label) {
  if (label.band >= 0) return 38.0;
  return label.mark == Mark::kNone ? 10.0 : 30.0;
}

double cellWidth(const StripCell& cell) {
  const double value =
      textWidth(bold15(), QString::fromStdString(cell.value)) + (cell.mark == Mark::kNone ? 0.0 : 20.0);
  const double meaning = textWidth(textFont(TextRole::kSecond), QString::fromStdString(cell.meaning));
  // Whole steps of 8, so that the strip does not breathe with every digit.
  return std::ceil(std::max(value, meaning) / 8.0) * 8.0 + 2.0 * kCellPadding;
}

QRectF stripBox(const std::vector<StripCell>& cells, const ViewSize& size, std::size_t row) {
  if (cells.empty()) return {};
  double width = 0.0;
  for (const StripCell& cell : cells) width += cellWidth(cell);
  const double above = static_cast<double>(row) * (kStripHeight + kStripGap);
  return {std::round(0.5 * (size.width - width)), size.height - 14.0 - kStripHeight - above, width, kStripHeight};
}

void paintStrip(QPainter& painter, const std::vector<StripCell>& cells, const QRectF& box, const Theme& theme) {
  if (box.isEmpty()) return;
  paintBox(painter, box, theme);
  double x = box.left();
  for (const StripCell& cell : cells) {
    const double width = cellWidth(cell);
    if (x > box.left()) {
      painter.setPen(QPen(theme.line, 1.0));
      painter.drawLine(QPointF(std::round(x) + 0.5, box.top() + 8), QPointF(std::round(x) + 0.5, box.bottom() - 8));
    }
    double text_x = x + kCellPadding;
    if (cell.mark != Mark::kNone) {
      paintMark(painter, cell.mark, QPointF(text_x + 6, box.top() + 14), 12, theme);
      text_x += 20;
    }
    painter.setFont(bold15());
    painter.setPen(theme.text1);
    painter.drawText(QRectF(text_x, box.top() + 4, width, 20), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::fromStdString(cell.value));
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    painter.drawText(QRectF(x + kCellPadding, box.top() + 22, width, 16), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::fromStdString(cell.meaning));
    x += width;
  }
}

}  // namespace

QPointF point(const glm::dvec2& p) {
  return {p.x, p.y};
}

QFont bold15() {
  return textFont(TextRole::kNumberOverScene);
}

double textWidth(const QFont& text_font, const QString& text) {
  return QFontMetricsF(text_font).horizontalAdvance(text);
}

/// A line with its halo below it.
void haloLine(QPainter& painter, const QPolygonF& line, const QColor& color, double width, const QColor& halo) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(halo, width + 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

void paintBox(QPainter& painter, const QRectF& box, const Theme& theme) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.scene.label_box);
  painter.drawRoundedRect(box, 4, 4);
}

void paintLabel(QPainter& painter, const OverlayLabel& label, const PlacedLabel& place, const Theme& theme) {
  const QColor color = label.band >= 0 ? theme.text1 : markColor(label.mark, theme);
  QPolygonF leader;
  for (const auto& p : leaderOf(place)) leader << point(p);
  haloLine(painter, leader, color, 1.2, theme.scene.halo);
  const QRectF box(point(place.box.min), point(place.box.max));
  paintBox(painter, box, theme);
  paintMark(painter, label.mark, QPointF(box.left() + 16, box.top() + 15), 12, theme);
  if (label.band >= 0) paintBand(painter, QRectF(box.left() + 10, box.top() + 8, 20, 13), label.band, theme);
  painter.setFont(bold15());
  painter.setPen(theme.text1);
  const double indent = indentOf(label);
  const QString number = QString::fromStdString(label.number);
  painter.drawText(QRectF(box.left() + indent, box.top() + 5, box.width() - indent - 6, 20),
                   Qt::AlignVCenter | Qt::AlignLeft, number);
  if (!label.title.empty()) {
    const double after = indent + textWidth(bold15(), number) + kBesideNumber;
    painter.setFont(textFont(TextRole::kText));
    painter.drawText(QRectF(box.left() + after, box.top() + 5, box.width() - after - 4, 20),
                     Qt::AlignVCenter | Qt::AlignLeft, QString::fromStdString(label.title));
  }
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text2);
  painter.drawText(QRectF(box.left() + 10, box.top() + 24, box.width() - 16, 16), Qt::AlignVCenter | Qt::AlignLeft,
                   QString::fromStdString(label.names));
}

QSizeF labelSize(const OverlayLabel& label) {
  double first = indentOf(label) + textWidth(bold15(), QString::fromStdString(label.number)) + 12.0;
  if (!label.title.empty())
    first += kBesideNumber + textWidth(textFont(TextRole::kText), QString::fromStdString(label.title));
  const double second = 10.0 + textWidth(textFont(TextRole::kSecond), QString::fromStdString(label.names)) + 10.0;
  return {std::ceil(std::max(first, second)), 44.0};
}

QRectF stripsBox(const Strips& strips, const ViewSize& size) {
  QRectF box;
  for (std::size_t row = 0; row < strips.size(); ++row) box = box.united(stripBox(strips[row], size, row));
  return box;
}

void paintStrips(QPainter& painter, const Strips& strips, const ViewSize& size, const Theme& theme) {
  for (std::size_t row = 0; row < strips.size(); ++row)
    paintStrip(painter, strips[row], stripBox(strips[row], size, row), theme);
}

QColor markColor(Mark mark, const Theme& theme) {
  switch (mark) {
    case Mark::kContact:
      return theme.contact;
    case Mark::kNearMiss:
      return theme.near_miss;
    case Mark::kLimit:
      return theme.limit;
    case Mark::kNone:
      break;
  }
  return theme.text2;
}

void paintMark(QPainter& painter, Mark mark, const QPointF& center, double size, const Theme& theme) {
  const double r = 0.5 * size;
  const QColor color = markColor(mark, theme);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  if (mark == Mark::kContact) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(
        QPolygonF({center + QPointF(0, -r), center + QPointF(r, 0), center + QPointF(0, r), center + QPointF(-r, 0)}));
  } else if (mark == Mark::kNearMiss) {
    painter.drawPolygon(
        QPolygonF({center + QPointF(0, -r * 0.9), center + QPointF(r, r * 0.8), center + QPointF(-r, r * 0.8)}));
  } else if (mark == Mark::kLimit) {
    painter.drawLine(center + QPointF(-r, -r), center + QPointF(-r, r));
    painter.drawLine(center + QPointF(r, -r), center + QPointF(r, r));
    painter.drawLine(center + QPointF(-r, 0), center + QPointF(r, 0));
  }
  painter.restore();
}

}  // namespace hapticell::app
