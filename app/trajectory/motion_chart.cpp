// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motion_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

using trajectory::MotionCurve;

constexpr int kLegendRow = 17, kLegendTop = 36;  // Above it stands the choice of the curves.

struct Range {
  double lowest, highest;
};

Range rangeOf(const MotionChart::Limit& limit, MotionChart::Order order) {
  const auto both = [](double most) {
    const double bound = most > 0.0 ? most : std::numeric_limits<double>::infinity();
    return Range{-bound, bound};
  };
  switch (order) {
    case MotionChart::Order::kSpeed:
      return both(limit.speed);
    case MotionChart::Order::kAcceleration:
      return both(limit.acceleration);
    case MotionChart::Order::kJerk:
      return both(limit.jerk);
    case MotionChart::Order::kValue:
      break;
  }
  return {limit.lowest, limit.highest};
}

const std::vector<double>& samplesOf(const MotionCurve& curve, MotionChart::Order order) {
  switch (order) {
    case MotionChart::Order::kSpeed:
      return curve.speed;
    case MotionChart::Order::kAcceleration:
      return curve.acceleration;
    case MotionChart::Order::kJerk:
      return curve.jerk;
    case MotionChart::Order::kValue:
      break;
  }
  return curve.value;
}

}  // namespace

MotionChart::MotionChart(QWidget* parent) : QWidget(parent) {
  setObjectName("motionChart");
  setAccessibleName(tr("Curves of the motion"));
  setMouseTracking(true);
}

void MotionChart::setCurves(std::shared_ptr<const trajectory::MotionCurves> curves) {
  curves_ = std::move(curves);
  update();
}

void MotionChart::setLimits(std::vector<Limit> limits) {
  limits_ = std::move(limits);
  update();
}

void MotionChart::setChoice(Group group, Order order) {
  group_ = group;
  order_ = order;
  update();
}

void MotionChart::setAxis(const TimeAxis& axis) {
  axis_ = axis;
  update();
}

void MotionChart::setTime(double t) {
  if (t == time_) return;
  time_ = t;
  update();
}

QRect MotionChart::plot() const {
  return QRect(QPoint(static_cast<int>(axis_.left), 8), QPoint(static_cast<int>(axis_.right), height() - 8));
}

/// Colours of the axes for x, y, z; joints take them in turn with other dashes.
std::vector<MotionChart::Shown> MotionChart::shown() const {
  std::vector<Shown> result;
  if (!curves_ || curves_->samples == 0) return result;
  const Theme& theme = themeOf(palette());
  const QColor colors[3] = {theme.axis_x, theme.axis_y, theme.axis_z};
  const Qt::PenStyle styles[3] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
  const auto add = [&](const MotionCurve& curve, std::size_t index, bool path) {
    Shown one;
    one.curve = &curve;
    one.samples = &samplesOf(curve, order_);
    one.color = path ? theme.selection : colors[index % 3];
    one.style = path ? Qt::SolidLine : styles[(index / 3) % 3];
    Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Limit& limit : limits_)
      if (limit.curve == curve.name) range = rangeOf(limit, order_);
    one.lowest = range.lowest;
    one.highest = range.highest;
    result.push_back(one);
  };
  switch (group_) {
    case Group::kPath:
      add(curves_->path, 0, true);
      break;
    case Group::kPlace:
      for (std::size_t i = 0; i < 3; ++i) add(curves_->cartesian[i], i, false);
      break;
    case Group::kTurn:
      for (std::size_t i = 3; i < 6; ++i) add(curves_->cartesian[i], i - 3, false);
      break;
    case Group::kJoints:
      for (std::size_t i = 0; i < curves_->joints.size(); ++i) add(curves_->joints[i], i, false);
      break;
  }
  return result;
}

double MotionChart::unitFactor() const {
  const bool metres = group_ == Group::kPath || group_ == Group::kPlace;
  const Units units = unitsNow();
  if (!metres) return units.perRadian();
  // Metres where figures would have five digits.
  const bool small = order_ == Order::kValue || order_ == Order::kSpeed;
  return small || units.length == Units::Length::kInch ? units.perMetre() : 1.0;
}

QString MotionChart::unit() const {
  const bool metres = group_ == Group::kPath || group_ == Group::kPlace;
  const Units units = unitsNow();
  const QString base = !metres                            ? units.angleUnit()
                       : unitFactor() == units.perMetre() ? units.lengthUnit()
                                                          : QStringLiteral("m");
  switch (order_) {
    case Order::kSpeed:
      return base + tr("/s");
    case Order::kAcceleration:
      return base + tr("/s²");
    case Order::kJerk:
      return base + tr("/s³");
    case Order::kValue:
      break;
  }
  return base;
}

double MotionChart::limitUse() const {
  double use = 0.0;
  for (const Shown& one : shown()) {
    const double middle = 0.5 * (one.lowest + one.highest), half = 0.5 * (one.highest - one.lowest);
    if (!std::isfinite(middle) || !(half > 0.0)) continue;
    for (const double value : *one.samples) use = std::max(use, std::abs(value - middle) / half);
  }
  return use;
}

double MotionChart::Scale::y(double value) const {
  return plot.bottom() - (value - low) / (high - low) * plot.height();
}

MotionChart::Scale MotionChart::scaleOf(const std::vector<Shown>& curves) const {
  Scale scale;
  scale.plot = plot();
  double low = 0.0, high = 0.0;
  bool any = false;
  for (const Shown& one : curves)
    for (const double value : *one.samples) {
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  // Limits are in the picture where the curve comes near them.
  for (const Shown& one : curves) {
    const double room = 0.05 * (one.highest - one.lowest);
    if (!std::isfinite(room)) continue;
    if (high > one.highest - 6.0 * room) high = std::max(high, one.highest + 0.5 * room);
    if (low < one.lowest + 6.0 * room) low = std::min(low, one.lowest - 0.5 * room);
  }
  if (order_ != Order::kValue) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  const double room = std::max(0.08 * (high - low), 1e-6);
  scale.low = (low - room) * unitFactor();
  scale.high = (high + room) * unitFactor();
  return scale;
}

void MotionChart::paintGrid(QPainter& painter, const Scale& scale) const {
  const Theme& theme = themeOf(palette());
  painter.fillRect(scale.plot, theme.field);
  painter.setFont(textFont(TextRole::kSecond));
  const double wanted = 34.0 / scale.plot.height() * (scale.high - scale.low);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= wanted) {
      step = factor * power;
      break;
    }
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
      const double y = scale.y(limit * unitFactor());
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
      const QPointF place(axis_.x(curves_->timeOf(i)), scale.y((*one.samples)[i] * unitFactor()));
      i == 0 ? path.moveTo(place) : path.lineTo(place);
    }
    painter.setPen(QPen(one.color, 1.6, one.style));
    painter.drawPath(path);
  }
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
    painter.setPen(QPen(one.color, 2, one.style));
    painter.drawLine(row.left(), row.center().y(), row.left() + 14, row.center().y());
    const double at = (time_ - curves_->begin) / curves_->step;
    const auto k = static_cast<std::size_t>(std::clamp(std::lround(at), 0L, static_cast<long>(curves_->samples) - 1));
    const double value = (*one.samples)[k] * unitFactor();
    painter.setPen(theme.text1);
    const QString name = QString::fromStdString(one.curve->name);
    const QString number = QString::number(std::abs(value) < 5e-3 ? 0.0 : value, 'f', std::abs(value) < 100 ? 2 : 0);
    const QRect words = row.adjusted(19, 0, 0, 0);
    const int number_width = painter.fontMetrics().horizontalAdvance(number + ' ' + unit());
    painter.drawText(words, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(name, Qt::ElideRight, words.width() - number_width - 6));
    painter.setPen(theme.text2);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight, number + ' ' + unit());
  }
}

void MotionChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  const std::vector<Shown> curves = shown();
  const QRect area = plot();
  if (area.width() < 40 || area.height() < 24) return;
  if (curves.empty()) {
    painter.fillRect(area, theme.field);
    painter.setPen(theme.text2);
    painter.setFont(textFont(TextRole::kText));
    const bool none = curves_ && group_ == Group::kJoints;
    painter.drawText(area, Qt::AlignCenter,
                     none ? tr("This motion has no joints.") : tr("Choose a motion to see its curves."));
    return;
  }
  const Scale scale = scaleOf(curves);
  paintGrid(painter, scale);
  painter.save();
  painter.setClipRect(area);
  paintLimits(painter, curves, scale);
  paintCurves(painter, curves, scale);
  painter.restore();
  const double x = axis_.x(time_);
  if (x >= area.left() && x <= area.right()) painter.fillRect(QRectF(x - 0.75, 0, 1.5, height()), theme.text1);
  paintLegend(painter, curves);
}

void MotionChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && event->position().x() >= axis_.left)
    emit scrubbed(axis_.t(std::min(event->position().x(), axis_.right)));
}

void MotionChart::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    emit scrubbed(axis_.t(std::clamp(event->position().x(), axis_.left, axis_.right)));
}

}  // namespace hapticell::app
