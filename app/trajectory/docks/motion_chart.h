// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <limits>
#include <memory>
#include <vector>

#include "app/trajectory/docks/time_axis.h"
#include "trajectory/motion/motion_curves.h"

namespace hapticell::app {

/// Position, speed, acceleration or jerk of the current motion over the time bar's axis, or all four in separate
/// plots, with limits if there are any and the values at the cursor. The curves of one plot share a scale; the
/// plot shows the largest use of their limits, and a band in the limit's colour marks where a curve exceeds its
/// limit.
class MotionChart : public QWidget {
  Q_OBJECT
 public:
  enum class Order { kValue, kSpeed, kAcceleration, kJerk, kAll };
  enum class Group { kPath, kPlace, kTurn, kJoints };

  explicit MotionChart(QWidget* parent = nullptr);
  /// Null: nothing is shown.
  void setCurves(std::shared_ptr<const trajectory::MotionCurves> curves);
  /// Bounds of a curve and of its three derivatives, by the curve's name; 0, or an infinite position: no bound.
  struct Limit {
    std::string curve;
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
    bool slides = false;  ///< A sliding joint: metres, not an angle.
  };
  void setLimits(std::vector<Limit> limits);
  void setChoice(Group group, Order order);
  void setAxis(const TimeAxis& axis);
  void setTime(double t);
  Group group() const { return group_; }
  Order order() const { return order_; }
  /// Largest fraction of a limit that a shown curve uses, with positions relative to the middle of their range; 0
  /// without a limit.
  double limitUse() const;
  QSize minimumSizeHint() const override { return {320, 70}; }
  QSize sizeHint() const override { return {900, 140}; }

 signals:
  void scrubbed(double t);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Shown {
    const trajectory::MotionCurve* curve = nullptr;
    const std::vector<double>* samples = nullptr;
    double lowest = 0.0, highest = 0.0;  ///< Limits in SI, infinite without limits.
    double factor = 1.0;                 ///< Shown units per SI unit.
    QString unit;
    QColor color;
    Qt::PenStyle style = Qt::SolidLine;
  };
  std::vector<Shown> shown(Order order) const;
  Shown shownCurve(const trajectory::MotionCurve& curve, Order order) const;
  /// The orders that have a plot, and the plots' positions.
  std::vector<std::pair<Order, QRect>> plots() const;
  static double limitUse(const std::vector<Shown>& curves);
  struct Scale {
    double low = -1.0, high = 1.0;  ///< In shown units.
    QRect plot;
    double y(double value) const;
  };
  static Scale scaleOf(const std::vector<Shown>& curves, Order order, const QRect& plot);
  void paintPlot(QPainter& painter, Order order, const QRect& plot) const;
  void paintGrid(QPainter& painter, const Scale& scale) const;
  void paintLimits(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale) const;
  void paintCurves(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale) const;
  void paintWords(QPainter& painter, const std::vector<Shown>& curves, const Scale& scale, Order order) const;
  void paintLegend(QPainter& painter, const std::vector<Shown>& curves) const;

  std::shared_ptr<const trajectory::MotionCurves> curves_;
  std::vector<Limit> limits_;
  Group group_ = Group::kPath;
  Order order_ = Order::kSpeed;
  TimeAxis axis_;
  double time_ = 0.0;
};

}  // namespace hapticell::app
