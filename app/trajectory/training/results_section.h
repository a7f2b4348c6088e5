// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "trajectory/training/training.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class ProgressPlot;

/// The section *Results* of the dock *Training*: the last run's score, progress over all runs, replay of a chosen run,
/// export. GUI thread.
class ResultsSection : public QObject {
  Q_OBJECT
 public:
  explicit ResultsSection(QVBoxLayout& column, QObject* parent = nullptr);

  /// Fills the list of runs again, the newest first.
  void fillRuns(const trajectory::TrainingSession& session);
  /// Index of the selected run among the session's attempts; 0 without a selection.
  std::size_t chosenRun() const;
  /// `pass`: score needed to pass.
  void show(const trajectory::TrainingSession& session, bool may_replay, double pass);

 signals:
  void replayWanted();
  void runChosen();
  void exportWanted();

 private:
  QLabel *score_, *unaided_;
  ProgressPlot* plot_;
  QComboBox* runs_;
  QPushButton *replay_, *export_;
};

}  // namespace hapticell::app
