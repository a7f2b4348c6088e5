// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "trajectory/training/training.h"

namespace hapticell::app {

/// The order for showing runs: practice, then separately retention, then transfer; each by time.
std::vector<std::size_t> shownOrder(const std::vector<trajectory::TrainingAttempt>& attempts);

/// Score and guidance of a trainee's runs over time: bars for the score (hatched if the run failed), a stepped line for
/// the guidance in practice. Runs without guidance are drawn separately after it, in another colour.
class ProgressPlot : public QWidget {
  Q_OBJECT
 public:
  explicit ProgressPlot(QWidget* parent = nullptr);
  /// `pass`: score from which a run is successful.
  void setAttempts(std::vector<trajectory::TrainingAttempt> attempts, double pass);
  QSize sizeHint() const override { return {300, 132}; }
  QSize minimumSizeHint() const override { return {200, 110}; }
  /// Paints it on any painter: on the panel and in the report.
  static void paint(QPainter& painter, const QRect& rect, const std::vector<trajectory::TrainingAttempt>& attempts,
                    double pass, const QPalette& palette);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<trajectory::TrainingAttempt> attempts_;
  double pass_ = 60.0;
};

}  // namespace hapticell::app
