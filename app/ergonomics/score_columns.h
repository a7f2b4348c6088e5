// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <map>

#include "mannequin/shape/body_shape.h"
#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::app {

class LiveScores;

/// Four bodies at the same task side by side: each with its picture, score, driver, REBA, OWAS and reach. A click
/// chooses one.
class ScoreColumns : public QWidget {
  Q_OBJECT
 public:
  explicit ScoreColumns(const LiveScores& scores, QWidget* parent = nullptr);
  void setMethod(ergonomics::ColourMethod method);
  QSize sizeHint() const override { return {540, 330}; }
  QSize minimumSizeHint() const override { return {300, 330}; }
  /// The chosen body; -1: none.
  int chosen() const { return chosen_; }

 signals:
  void chose(int body);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF columnRect(int body) const;
  void paintColumn(QPainter& painter, int body);
  void choose(int body);
  const std::vector<mannequin::Flesh>& fleshOf(std::size_t body);
  const LiveScores& scores_;
  ergonomics::ColourMethod method_ = ergonomics::ColourMethod::kRula;
  std::map<std::size_t, std::vector<mannequin::Flesh>> flesh_;
  int chosen_ = -1;
};

}  // namespace hapticell::app
