// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::app {

/// Sub-scores of the worse side in two columns: name, number, colour patch, reason. For EN 1005-4 and ISO 11226, the
/// zones of the body parts instead.
class SubScoreTable : public QWidget {
  Q_OBJECT
 public:
  explicit SubScoreTable(QWidget* parent = nullptr);
  struct Row {
    QString name, number, reason;
    int band = -1;
  };
  void setRows(std::vector<Row> rows);
  const std::vector<Row>& rows() const { return rows_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {300, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Width of the names, pixels: that of the longest, but limited so that the reasons have room.
  double nameWidth() const;

  std::vector<Row> rows_;
};

std::vector<SubScoreTable::Row> subScoreRows(const ergonomics::PostureScores& scores, ergonomics::ColourMethod method);

}  // namespace hapticell::app
