// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/motion_chart.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "app/style/theme.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

using trajectory::MotionCurve;

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
    case MotionChart::Order::kAll:
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
    case MotionChart::Order::kAll:
      break;
  }
  return curve.value;
}

QString perTime(MotionChart::Order order) {
  switch (order) {
    case MotionChart::Order::kSpeed:
      return MotionChart::tr("/s");
    case MotionChart::Order::kAcceleration:
      return MotionChart::tr("/s²");
    case MotionChart::Order::kJerk:
      return MotionChart::tr("/s³");
    case MotionChart::Order::kValue:
    case MotionChart::Order::kAll:
      break;
  }
  return {};
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

std::vector<std::pair<MotionChart::Order, QRect>> MotionChart::plots() const {
  const int left = static_cast<int>(axis_.left), width = static_cast<int>(axis_.right) - left;
  if (order_ != Order::kAll) return {{order_, QRect(left, 8, width, height() - 16)}};
  std::vector<std::pair<Order, QRect>> result;
  const int pitch = (height() - 8) / 4;
  int top = 8;
  for (const Order order : {Order::kValue, Order::kSpeed, Order::kAcceleration, Order::kJerk}) {
    result.emplace_back(order, QRect(left, top, width, pitch - 8));
    top += pitch;
  }
  return result;
}

MotionChart::Shown MotionChart::shownCurve(const MotionCurve& curve, Order order) const {
  Shown one;
  one.curve = &curve;
  one.samples = &samplesOf(curve, order);
  Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  bool metres = group_ == Group::kPath || group_ == Group::kPlace;
  for (const Limit& limit : limits_) {
    if (limit.curve != curve.name) continue;
    range = rangeOf(limit, order);
    metres = metres || limit.slides;
  }
  one.lowest = range.lowest;
  one.highest = range.highest;
  const Units units = unitsNow();
  // Metres where figures would have five digits.
  const bool small = order == Order::kValue || order == Order::kSpeed || units.length == Units::Length::kInch;
  one.factor = small ? units.perMetre() : 1.0;
  one.unit = small ? units.lengthUnit() : QStringLiteral("m");
  if (!metres) {
    one.factor = units.perRadian();
    one.unit = units.angleUnit();
  }
  one.unit += perTime(order);
  return one;
}

/// Colours of the axes for x, y, z; joints take them in turn with other dashes.
std::vector<MotionChart::Shown> MotionChart::shown(Order order) const {
  std::vector<Shown> result;
  if (!curves_ || curves_->samples == 0) return result;
  const Theme& theme = themeOf(palette());
  const QColor colors[3] = {theme.scene.axis_x, theme.scene.axis_y, theme.scene.axis_z};
  const Qt::PenStyle styles[3] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
  const auto add = [&](const MotionCurve& curve, std::size_t index, bool path) {
    result.push_back(shownCurve(curve, order));
    result.back().color = path ? theme.selection : colors[index % 3];
    result.back().style = path ? Qt::SolidLine : styles[(index / 3) % 3];
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

double MotionChart::limitUse(const std::vector<Shown>& curves) {
  double use = 0.0;
  for (const Shown& one : curves) {
    const double middle = 0.5 * (one.lowest + one.highest), half = 0.5 * (one.highest - one.lowest);
    if (!std::isfinite(middle) || !(half > 0.0) || !std::isfinite(half)) continue;
    for (const double value : *one.samples) use = std::max(use, std::abs(value - middle) / half);
  }
  return use;
}

double MotionChart::limitUse() const {
  double use = 0.0;
  for (const auto& [order, plot] : plots()) use = std::max(use, limitUse(shown(order)));
  return use;
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
