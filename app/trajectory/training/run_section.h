// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "trajectory/training/training.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;

/// The section *Run* of the dock *Training*: the kind of run, its progress, whether forces are on, and the buttons to
/// start and end it. GUI thread.
class RunSection : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  RunSection(Host& host, QVBoxLayout& column, QObject* parent = nullptr);

  trajectory::RunKind kind() const;
  struct State {
    bool is_running = false, has_exercise = false;
    QString note;        ///< The last note; empty: none.
    double share = 0.0;  ///< Progress along the motion during a run, 0 to 1.
  };
  void show(const State& state);
  /// Updates the text for forces on or off; the rest stays as shown last.
  void showForces();
  /// Shows advice for this kind of run, at this time in the trainee's session.
  void showKind(const trajectory::TrainingSession& session, const std::string& now);
  /// True if a stylus is connected and its forces are off.
  bool forcesAreOff() const;

 signals:
  void kindChosen();
  void startClicked();  ///< The main button: start with forces, or end the run.
  void startWithoutForces();

 private:
  Host& host_;
  QComboBox* kind_;
  QLabel *help_label_, *state_, *forces_;
  QProgressBar* way_;
  QPushButton *start_, *without_;
  bool is_running_ = false, has_exercise_ = false;
};

}  // namespace hapticell::app
