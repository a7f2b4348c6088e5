// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "app/ergonomics/paced_refresh.h"
#include "mannequin/ergonomics/advice/better_place.h"

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
  ergonomics::ColourMethod method() const { return tab_.method; }
  /// The method that the scene's labels speak of.
  ergonomics::PostureMethod labelledMethod() const;
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
  // What the panel is made of, from above.
  QWidget* makeEmptyPage();
  QWidget* makeMethodRows();
  QWidget* makeWhyBox();
  QWidget* makeFigures();
  void listen();
  void showScores();
  QString sumsText() const;
  QString liftText() const;
  void showAdvice();
  void takeBetterPosture();
  QString whyText() const;
  QString whyTitle() const;
  /// The methods of the tab that is chosen; none on the one about loads.
  std::vector<ergonomics::PostureMethod> shownMethods() const;
  /// What the button shows: the first of the tab's methods that knows a better place.
  const ergonomics::BetterPlace* betterPlace() const;
  void chooseOwnLimits();
  MannequinContext& context_;
  LiveScores& scores_;
  /// What is chosen above the scores.
  struct Tab {
    ergonomics::ColourMethod method = ergonomics::ColourMethod::kRula;
    bool shows_load = false;  ///< The tab about lifting and forces, which has no colours of its own.
  } tab_;
  QWidget *empty_, *content_;
  Segmented* methods_;
  QLabel *live_, *title_, *why_, *table_title_, *sums_, *lift_, *missing_;
  ScoreColumns* columns_;
  SubScoreTable* sub_scores_;
  HeightStrips* heights_;
  QCheckBox* all_bodies_;
  QPushButton *show_posture_, *limits_;
  PacedRefresh pace_;
};

}  // namespace hapticell::app
