// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/studies/chart_axis.h"

namespace hapticell::app {

class ResultTable;

/// Two columns of results against each other: feasible variants filled, others hollow, the Pareto front joined. A click
/// chooses the nearest variant; arrow keys go to its neighbours.
class ScatterChart : public QWidget {
  Q_OBJECT
 public:
  explicit ScatterChart(const ResultTable& table, QWidget* parent = nullptr);
  void setColumns(int across, int up);
  /// Where a row is drawn, in pixels; nothing without both values.
  std::optional<QPointF> placeOf(std::size_t row) const;
  QSize minimumSizeHint() const override { return {240, 110}; }

 signals:
  void chose(std::int64_t number);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void scale();
  QRectF plot() const;
  std::optional<std::size_t> nearest(const QPointF& place) const;
  void paintAxes(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;

  const ResultTable& table_;
  int across_ = -1, up_ = -1;
  ChartAxis x_, y_;
};

}  // namespace hapticell::app
