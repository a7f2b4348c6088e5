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

/// The section *Run* of the dock *Training*: what kind of run, how far it is, whether the forces are on, and the
/// buttons that begin and end it. GUI thread.
class RunSection : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  RunSection(Host& host, QVBoxLayout& column, QObject* parent = nullptr);

  trajectory::RunKind kind() const;
  struct State {
    bool is_running = false, has_exercise = false;
    QString note;        ///< What was said last; empty: nothing.
    double share = 0.0;  ///< Of the way, while a run goes on.
  };
  void show(const State& state);
  /// Another word where the forces went on or off; with the rest of the state as shown last.
  void showForces();
  /// What is good to know of this kind of run, at this time in the trainee's session.
  void showKind(const trajectory::TrainingSession& session, const std::string& now);
  /// A stylus is connected, and its forces are off.
  bool forcesAreOff() const;

 signals:
  void kindChosen();
  void startClicked();  ///< The main button: begin with forces, or end the run.
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
