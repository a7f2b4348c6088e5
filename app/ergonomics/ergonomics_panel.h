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

/// The scores while the hand is dragged: method, four bodies, reasons, sub-scores, and scores by height of the work.
class ErgonomicsPanel : public QWidget {
  Q_OBJECT
 public:
  ErgonomicsPanel(MannequinContext& context, LiveScores& scores, QWidget* parent = nullptr);
  ergonomics::ColourMethod method() const { return tab_.method; }
  /// The method whose scores the labels in the scene show.
  ergonomics::PostureMethod labelledMethod() const;
  /// The chosen column; -1: none.
  int chosenBody() const;
  /// Whether the scene shows all four bodies.
  bool showsAllBodies() const;

 signals:
  void methodChanged();
  void taskWanted();
  void searchWanted();
  void reportWanted();
  void addWanted();
  void bodyChosen(int body);

 private:
  // The pieces of the panel, from top to bottom.
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
  /// The methods of the chosen tab; empty on the tab about loads.
  std::vector<ergonomics::PostureMethod> shownMethods() const;
  /// What the button offers: the better placement from the first of the tab's methods that has one.
  const ergonomics::BetterPlace* betterPlace() const;
  void chooseOwnLimits();
  MannequinContext& context_;
  LiveScores& scores_;
  /// What is chosen in the tabs above the scores.
  struct Tab {
    ergonomics::ColourMethod method = ergonomics::ColourMethod::kRula;
    bool shows_load = false;  ///< The tab about lifting and forces, which has no colours.
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
