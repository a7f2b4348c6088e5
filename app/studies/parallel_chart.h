// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "app/studies/chart_axis.h"

namespace hapticell::app {

class ResultTable;

/// Parallel coordinates (Inselberg 1985): an axis a column, a line a variant. What varies comes first, then what is
/// required and the objectives. A click chooses the nearest line; the wheel and the arrow keys go through the variants.
class ParallelChart : public QWidget {
  Q_OBJECT
 public:
  explicit ParallelChart(const ResultTable& table, QWidget* parent = nullptr);
  /// The column that colours the lines.
  void setColorColumn(int column);
  const std::vector<ChartAxis>& axes() const { return axes_; }
  /// Where a row crosses an axis, in pixels.
  QPointF placeOf(std::size_t row, std::size_t axis) const;
  QSize minimumSizeHint() const override { return {240, 110}; }

 signals:
  void chose(std::int64_t number);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void scale();
  QRectF plot() const;
  QPolygonF lineOf(std::size_t row) const;
  QColor colorOf(std::size_t row) const;
  void paintAxes(QPainter& painter) const;

  const ResultTable& table_;
  int color_ = -1;
  ChartAxis color_axis_;
  std::vector<ChartAxis> axes_;
};

}  // namespace hapticell::app
