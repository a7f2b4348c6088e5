// SPDX-License-Identifier: Apache-2.0
// How the chart looks.
#include "app/trajectory/docks/motion_chart.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kLegendRow = 17, kLegendTop = 36;  // Above it stands the choice of the curves.

}  // namespace

double MotionChart::Scale::y(double value) const {
  return plot.bottom() - (value - low) / (high - low) * plot.height();
}

MotionChart::Scale MotionChart::scaleOf(const std::vector<Shown>& curves, Order order, const QRect& plot) {
  Scale scale;
  scale.plot = plot;
  double low = 0.0, high = 0.0;
  bool any = false;
  for (const Shown& one : curves)
    for (const double sample : *one.samples) {
      const double value = sample * one.factor;
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  // Limits are in the picture where the curve comes near them.
  for (const Shown& one : curves) {
    const double most = one.highest * one.factor, least = one.lowest * one.factor, room = 0.05 * (most - least);
    if (!std::isfinite(room)) continue;
    if (high > most - 6.0 * room) high = std::max(high, most + 0.5 * room);
    if (low < least + 6.0 * room) low = std::min(low, least - 0.5 * room);
  }
  if (order != Order::kValue) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  const double room = std::max(0.08 * (high - low), 1e-6);
  scale.low = low - room;
  scale.high = high + room;
  return scale;
}

void MotionChart::paintGrid(QPainter& painter, const Scale& scale) const {
  const Theme& theme = themeOf(palette());
  painter.fillRect(scale.plot, theme.field);
  painter.setFont(textFont(TextRole::kSecond));
  // Two figures at least, where they have room.
  const double pitch = std::clamp(0.4 * scale.plot.height(), 15.0, 34.0);
  const double wanted = pitch / scale.plot.height() * (scale.high - scale.low);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const auto inside = [&scale](double step) {
    return std::floor(scale.high / step) - std::ceil(scale.low / step) + 1.0;
  };
  double step = 10.0 * power, finer = 5.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= wanted) {
      step = factor * power;
      finer = factor == 5.0 ? 2.0 * power : 0.5 * step;
    }
  constexpr double kLeastPitch = 12.0;
  if (inside(step) < 2.0 && finer / (scale.high - scale.low) * scale.plot.height() >= kLeastPitch) step = finer;
  for (double value = std::ceil(scale.low / step) * step; value <= scale.high; value += step) {
    const double y = std::round(scale.y(value));
    const bool zero = std::abs(value) < 1e-6 * step;
    painter.fillRect(QRectF(scale.plot.left(), y, scale.plot.width(), 1), zero ? theme.text3 : theme.line);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(scale.plot.right() + 6, y - 9, 54, 18), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::number(zero ? 0.0 : value, 'g', 4));
  }
}

void MotionChart::paintLimits(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale) const {
  const Theme& theme = themeOf(palette());
  for (const Shown& one : curves) {
    for (const double limit : {one.highest, one.lowest}) {
      if (!std::isfinite(limit)) continue;
      const double y = scale.y(limit * one.factor);
      if (y < scale.plot.top() || y > scale.plot.bottom()) continue;
      painter.setPen(QPen(theme.limit, 1.2));
      painter.drawLine(QPointF(scale.plot.left(), y), QPointF(scale.plot.right(), y));
    }
    QColor band = theme.limit;
    band.setAlpha(70);
    for (std::size_t i = 0; i < one.samples->size(); ++i) {
      const double value = (*one.samples)[i], slack = 1e-3 * std::abs(value);
      if (value >= one.lowest - slack && value <= one.highest + slack) continue;
      const double x = axis_.x(curves_->timeOf(i));
      painter.fillRect(QRectF(x - 1.0, scale.plot.top(), 2.0, scale.plot.height()), band);
    }
  }
}

void MotionChart::paintCurves(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale) const {
  painter.setBrush(Qt::NoBrush);
  for (const Shown& one : curves) {
    QPainterPath path;
    for (std::size_t i = 0; i < one.samples->size(); ++i) {
      const QPointF place(axis_.x(curves_->timeOf(i)), scale.y((*one.samples)[i] * one.factor));
      i == 0 ? path.moveTo(place) : path.lineTo(place);
    }
    painter.setPen(QPen(one.color, 1.6, one.style));
    painter.drawPath(path);
  }
}

void MotionChart::paintWords(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale,
                             Order order) const {
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  const QRect words = scale.plot.adjusted(6, 1, -6, 0);
  QColor back = theme.field;
  back.setAlpha(200);
  const auto write = [&](const QString& text, Qt::Alignment side, const QColor& color) {
    const QRect box = painter.fontMetrics().boundingRect(words, static_cast<int>(side | Qt::AlignTop), text);
    painter.fillRect(box.adjusted(-3, 0, 3, 0), back);
    painter.setPen(color);
    painter.drawText(words, static_cast<int>(side | Qt::AlignTop), text);
  };
  const QString names[] = {tr("Position"), tr("Speed"), tr("Acceleration"), tr("Jerk")};
  if (order_ == Order::kAll)
    write(QStringLiteral("%1, %2").arg(names[static_cast<int>(order)], curves.front().unit), Qt::AlignLeft,
          theme.text2);
  if (const double use = limitUse(curves); use > 0.0)
    write(tr("%1 % of the limits").arg(100.0 * use, 0, 'f', 0), Qt::AlignRight,
          use > 1.001 ? theme.limit : theme.text2);
}

void MotionChart::paintLegend(QPainter& painter, const std::vector<Shown>& curves) const {
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kSecond));
  const int rows = std::max(1, (height() - kLegendTop - 4) / kLegendRow);
  const int columns = (static_cast<int>(curves.size()) + rows - 1) / rows;
  const int width = (static_cast<int>(axis_.left) - 20) / std::max(1, columns);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Shown& one = curves[i];
    const QRect row(12 + static_cast<int>(i) / rows * width, kLegendTop + static_cast<int>(i) % rows * kLegendRow,
                    width - 8, kLegendRow);
    const int dash = columns > 1 ? 10 : 14;
    painter.setPen(QPen(one.color, 2, one.style));
    painter.drawLine(row.left(), row.center().y(), row.left() + dash, row.center().y());
    const double at = (time_ - curves_->begin) / curves_->step;
    const auto k = static_cast<std::size_t>(std::clamp(std::lround(at), 0L, static_cast<long>(curves_->samples) - 1));
    const double value = (*one.samples)[k] * one.factor;
    const QString name = QString::fromStdString(one.curve->name);
    QString number = QString::number(std::abs(value) < 5e-3 ? 0.0 : value, 'f', std::abs(value) < 100 ? 2 : 0);
    if (columns < 2) number += ' ' + one.unit;
    const QRect words = row.adjusted(dash + 5, 0, 0, 0);
    // Beside each other there is room for what they are only; with all four plots there is no one number.
    const bool with_number =
        order_ != Order::kAll && painter.fontMetrics().horizontalAdvance(name + number) + 8 <= words.width();
    const int taken = with_number ? painter.fontMetrics().horizontalAdvance(number) + 6 : 0;
    painter.setPen(theme.text1);
    painter.drawText(
        words, Qt::AlignVCenter,
        painter.fontMetrics().elidedText(name, columns > 1 ? Qt::ElideMiddle : Qt::ElideRight, words.width() - taken));
    if (!with_number) continue;
    painter.setPen(theme.text2);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight, number);
  }
}

void MotionChart::paintPlot(QPainter& painter, Order order, const QRect& plot) const {
  const std::vector<Shown> curves = shown(order);
  const Scale scale = scaleOf(curves, order, plot);
  paintGrid(painter, scale);
  painter.save();
  painter.setClipRect(plot);
  paintLimits(painter, curves, scale);
  paintCurves(painter, curves, scale);
  paintWords(painter, curves, scale, order);
  painter.restore();
}

void MotionChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  const auto all = plots();
  const QRect area(all.front().second.topLeft(), all.back().second.bottomRight());
  if (area.width() < 40 || area.height() < 24) return;
  const std::vector<Shown> curves = shown(all.front().first);
  if (curves.empty()) {
    painter.fillRect(area, theme.field);
    painter.setPen(theme.text2);
    painter.setFont(textFont(TextRole::kText));
    const bool none = curves_ && group_ == Group::kJoints;
    painter.drawText(area, Qt::AlignCenter,
                     none ? tr("This motion has no joints.") : tr("Choose a motion to see its curves."));
    return;
  }
  for (const auto& [order, plot] : all) paintPlot(painter, order, plot);
  const double x = axis_.x(time_);
  if (x >= area.left() && x <= area.right()) painter.fillRect(QRectF(x - 0.75, 0, 1.5, height()), theme.text1);
  paintLegend(painter, curves);
}

}  // namespace hapticell::app
