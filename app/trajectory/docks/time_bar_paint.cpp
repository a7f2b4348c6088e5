// SPDX-License-Identifier: Apache-2.0
// How the time bar looks.
#include "app/trajectory/docks/time_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr double kDot = 3.5;

/// Of seconds at marks that stand a step apart.
int tickDecimals(double step) {
  if (step < 0.1) return 2;
  return step < 1.0 ? 1 : 0;
}

}  // namespace

QColor colorOf(CheckMark mark, const Theme& theme) {
  switch (mark) {
    case CheckMark::kCollision:
      return theme.contact;
    case CheckMark::kLimit:
      return theme.limit;
    case CheckMark::kCareful:
      return theme.near_miss;
    case CheckMark::kFree:
    case CheckMark::kNone:
      break;
  }
  return theme.text1;
}

void TimeBar::paintRuler(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  painter.setFont(textFont(TextRole::kSecond));
  for (const TimeAxis::Tick& tick : at.ticks()) {
    const double x = std::round(at.x(tick.t));
    painter.fillRect(QRectF(x, kRuler - (tick.named ? 10 : 6), 1, tick.named ? 8 : 4), theme.text3);
    if (!tick.named || std::abs(x - at.x(time_)) < 44) continue;
    painter.setPen(theme.text2);
    const int decimals = tickDecimals(60.0 / at.pixelsPerSecond());
    painter.drawText(QRectF(x - 34, 0, 68, 18), Qt::AlignCenter, tr("%1 s").arg(tick.t, 0, 'f', decimals));
  }
}

void TimeBar::paintDots(QPainter& painter, const TrackRow& row, const QRect& bar) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  const double y = bar.center().y() + 0.5;
  double last = -1e9;
  for (const TrackDot& dot : row.dots) {
    const double x = at.x(dot.t);
    const bool chosen = row.current && frame_ && *frame_ == dot.frame;
    if (x < at.left - 4 || x > at.right + 4 || (x - last < (dot.by_hand ? 3.0 : 10.0) && !chosen)) continue;
    last = x;
    const QColor color = colorOf(dot.mark, theme);
    painter.setPen(QPen(chosen ? theme.selection : color, chosen ? 2.5 : 1.4));
    painter.setBrush(dot.mark == CheckMark::kFree || chosen ? QBrush(color) : QBrush(Qt::NoBrush));
    // Shape beside colour: diamond, H, triangle, ring (checked and free: disc).
    if (dot.mark == CheckMark::kCollision) {
      painter.setBrush(color);
      const QPointF diamond[4] = {{x, y - 5}, {x + 5, y}, {x, y + 5}, {x - 5, y}};
      painter.drawPolygon(diamond, 4);
    } else if (dot.mark == CheckMark::kLimit) {
      painter.drawLine(QPointF(x - 3, y - 4), QPointF(x - 3, y + 4));
      painter.drawLine(QPointF(x + 3, y - 4), QPointF(x + 3, y + 4));
      painter.drawLine(QPointF(x - 3, y), QPointF(x + 3, y));
    } else if (dot.mark == CheckMark::kCareful) {
      const QPointF triangle[3] = {{x, y - 5}, {x + 5, y + 4}, {x - 5, y + 4}};
      painter.drawPolygon(triangle, 3);
    } else {
      double size = dot.by_hand ? kDot + 0.5 : kDot - 1.0;
      if (chosen) size = kDot + 1.5;
      painter.drawEllipse(QPointF(x, y), size, size);
    }
  }
}

void TimeBar::paintRow(QPainter& painter, std::size_t index) const {
  const Theme& theme = themeOf(palette());
  const TrackRow& row = rows_[index];
  const QRect rect = rowRect(index);
  const TimeAxis at = axis();
  if (row.current) {
    painter.fillRect(QRect(0, rect.top(), kNames - 8, rect.height()), theme.selected_row);
    painter.fillRect(QRect(0, rect.top(), 2, rect.height()), theme.selection);
  }
  const QPointF light(18.5, rect.center().y() + 0.5);
  painter.setPen(QPen(row.playable ? theme.text1 : theme.text3, 1.4));
  painter.setBrush(row.played ? QBrush(theme.selection) : QBrush(Qt::NoBrush));
  painter.drawEllipse(light, 4.5, 4.5);
  painter.setFont(textFont(TextRole::kText));
  painter.setPen(row.playable ? theme.text1 : theme.text3);
  const QRect words(32, rect.top(), kNames - 48, rect.height());
  painter.drawText(words, Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(QString::fromStdString(row.name), Qt::ElideRight, words.width()));
  const int left = static_cast<int>(std::max(at.left, at.x(row.begin))),
            right = static_cast<int>(std::min(at.right, at.x(row.end)));
  const QRect bar(left, rect.top() + 4, std::max(2, right - left), rect.height() - 8);
  painter.save();
  painter.setClipRect(QRectF(at.left - 6, rect.top(), at.right - at.left + 12, rect.height()));
  if (row.end > row.begin)
    drawBox(&painter, bar, row.played ? theme.selected_row : theme.field, row.played ? theme.selection : theme.line, 2);
  for (const TrackSpan& span : row.spans) {
    const double from = at.x(span.t_in), to = std::max(from + 3.0, at.x(span.t_out));
    QColor color = colorOf(span.mark, theme);
    painter.fillRect(QRectF(from, bar.bottom() - 2, to - from, 3), color);
    color.setAlpha(50);
    painter.fillRect(QRectF(from, bar.top() + 1, to - from, bar.height() - 1), color);
  }
  paintDots(painter, row, bar);
  painter.restore();
  if (row.note.isEmpty()) return;
  // Beside the bar where there is room, else in it.
  painter.setFont(textFont(TextRole::kSecond));
  const int width = painter.fontMetrics().horizontalAdvance(row.note) + 12;
  const bool beside = right + 10 + width < at.right;
  painter.setPen(theme.text2);
  if (!beside) {
    const QRect box(left + 10, bar.top() + 1, std::min(width, bar.width() - 14), bar.height() - 1);
    QColor back = theme.dock;
    back.setAlpha(210);
    painter.fillRect(box, back);
    painter.drawText(box.adjusted(4, 0, -4, 0), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.note, Qt::ElideRight, box.width() - 8));
  } else {
    painter.drawText(QRect(right + 10, rect.top(), width, rect.height()), Qt::AlignVCenter, row.note);
  }
}

void TimeBar::paintPart(QPainter& painter) const {
  if (!part_) return;
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  QColor veil = theme.dock;
  veil.setAlpha(150);
  const double from = std::clamp(at.x(part_->from), at.left, at.right),
               to = std::clamp(at.x(part_->to), at.left, at.right);
  painter.fillRect(QRectF(at.left, kRuler, from - at.left, height() - kRuler), veil);
  painter.fillRect(QRectF(to, kRuler, at.right - to, height() - kRuler), veil);
  painter.setPen(QPen(theme.selection, 2));
  for (const auto& [x, side] : {std::pair(from, 5.0), std::pair(to, -5.0)}) {
    painter.drawLine(QPointF(x, 16), QPointF(x, height()));
    painter.drawLine(QPointF(x, 16), QPointF(x + side, 16));
    painter.drawLine(QPointF(x, kRuler - 1), QPointF(x + side, kRuler - 1));
  }
}

void TimeBar::paintCursor(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  const double x = recorded_ ? at.x(*recorded_) : at.x(time_);
  if (x < at.left - 1 || x > at.right + 1) return;
  painter.fillRect(QRectF(x - 0.75, 18, 1.5, height() - 18), theme.text1);
  const QRect box(static_cast<int>(x) - 26, 1, 52, 18);
  drawBox(&painter, box, theme.text1, theme.text1, 3);
  painter.setFont(textFont(TextRole::kSection));
  painter.setPen(theme.dock);
  painter.drawText(box, Qt::AlignCenter, QString::number(recorded_.value_or(time_), 'f', 2));
}

void TimeBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kText));
  paintRuler(painter);
  painter.save();
  painter.setClipRect(QRect(0, kRuler, width(), height() - kRuler));
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (rowRect(row).bottom() > kRuler && rowRect(row).top() < height()) paintRow(painter, row);
  if (recorded_) {
    const QRect rect = rowRect(rows_.size());
    const TimeAxis at = axis();
    painter.setPen(theme.text1);
    painter.drawText(QRect(32, rect.top(), kNames - 60, rect.height()), Qt::AlignVCenter, tr("recording"));
    painter.setBrush(theme.contact);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(kNames - 22, rect.center().y() + 0.5), 5, 5);
    const QRect bar(static_cast<int>(at.x(0.0)), rect.top() + 4, static_cast<int>(at.x(*recorded_) - at.x(0.0)),
                    kRow - 8);
    drawBox(&painter, bar, theme.selected_row, theme.selection, 2);
  }
  painter.restore();
  if (rows_.empty() && !recorded_) {
    painter.setPen(theme.text2);
    painter.drawText(QRect(kNames, kRuler, width() - kNames - kRightRoom, height() - kRuler),
                     Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No motion yet. Press R, move an entity, press R again; or import one."));
  }
  paintPart(painter);
  paintCursor(painter);
  if (hasFocus()) {
    painter.setPen(QPen(theme.selection, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

}  // namespace hapticell::app
