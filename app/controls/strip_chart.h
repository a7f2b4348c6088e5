// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/controls/strip_history.h"

namespace hapticell::app {

/// Relates time to pixels for a chart, so that it shares another widget's time axis and cursor.
struct StripTimes {
  double left = 0.0, right = 1.0;      ///< Pixels of the drawn range.
  double begin_s = 0.0, end_s = 20.0;  ///< Snapshot times at these pixels.
};

/// Force on the hand and smallest clearance over the last seconds; below them, the rates of the haptic and the
/// collision loop. The cursor reads all of them at its time.
class StripChart : public QWidget {
  Q_OBJECT
 public:
  explicit StripChart(double length_s = 20.0, QWidget* parent = nullptr);
  /// Uses these times from now on. The chart then shows no time axis and no rates of its own.
  void setTimes(const StripTimes& times);
  /// Takes the newest state; draws at most 30 times a second, and only while visible.
  void take(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// The near-miss distance (m) and the device's peak force (N; 0: none).
  void setLevels(double near_miss_m, double peak_n);
  /// Clears the chart, for another document.
  void clear();
  const StripHistory& history() const { return history_; }
  QSize minimumSizeHint() const override { return {320, times_ ? 70 : 140}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  struct Axes;
  Axes axes() const;
  void paintTimes(QPainter& painter, const Axes& axes) const;
  void paintLevels(QPainter& painter, const Axes& axes) const;
  void paintCurves(QPainter& painter, const Axes& axes) const;
  void paintRates(QPainter& painter, const Axes& axes) const;
  void paintLegend(QPainter& painter, const Axes& axes) const;
  void paintCursor(QPainter& painter, const Axes& axes) const;
  StripHistory history_;
  std::optional<StripTimes> times_;
  double near_miss_m_ = 0.010, peak_n_ = 0.0;
  int cursor_ = -1;
};

}  // namespace hapticell::app
