// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "mannequin/ergonomics/posture_scores.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace hapticell::app {

class HeightStrips;
class LiveScores;
class MannequinContext;
class ScoreColumns;
class Segmented;
class SubScoreTable;

/// The scores while the hand is dragged: method, four bodies, why, sub-scores, and the scores by height of the work.
class ErgonomicsPanel : public QWidget {
  Q_OBJECT
 public:
  ErgonomicsPanel(MannequinContext& context, LiveScores& scores, QWidget* parent = nullptr);
  ergonomics::ColourMethod method() const { return method_; }
  /// The column that is chosen; -1: none.
  int chosenBody() const;
  /// Whether all four bodies are to be seen in the scene.
  bool showsAllBodies() const;

 signals:
  void methodChanged();
  void taskWanted();
  void searchWanted();
  void reportWanted();
  void addWanted();
  void bodyChosen(int body);

 private:
  void showScores();
  void showAdvice();
  void takeBetterPosture();
  void chooseOwnLimits();
  MannequinContext& context_;
  LiveScores& scores_;
  ergonomics::ColourMethod method_ = ergonomics::ColourMethod::kRula;
  QWidget *empty_, *content_;
  Segmented* methods_;
  QLabel *live_, *title_, *why_, *table_title_, *sums_, *lift_, *missing_;
  bool shows_load_ = false;  ///< The tab about lifting and forces, which has no colours of its own.
  ScoreColumns* columns_;
  SubScoreTable* sub_scores_;
  HeightStrips* heights_;
  QCheckBox* all_bodies_;
  QPushButton *show_posture_, *task_, *limits_;
};

}  // namespace hapticell::app
