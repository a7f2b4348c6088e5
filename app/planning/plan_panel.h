// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <cstdint>

#include "app/planning/path_planner.h"
#include "app/planning/plan_goal_form.h"
#include "workcell/entity/entity.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace hapticell::app {

class Host;
class LiveLabel;
class ThroughList;
class ValueField;

/// Plans a path for the selected robot or solid, or for a hand of the selected mannequin, and adds it to the motions of
/// the document, as a recording is. Shows its figures, or why no path was found. GUI thread.
class PlanPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlanPanel(Host& host, QWidget* parent = nullptr);

 private:
  void addSettings(class QVBoxLayout& column);
  void addRun(class QVBoxLayout& column);
  const workcell::Entity* entity() const;
  mannequin::Side hand() const;
  /// The external axes that move along with it, the lowest first.
  PlanGoalForm::Axes axes() const;
  void showAxes();
  void follow();
  void plan();
  void take(const PathAnswer& answer);
  void showFailure(const planning::Failure& failure);
  void refresh();

  Host& host_;
  PathPlanner planner_;
  workcell::EntityId id_ = 0;       ///< What is planned for; stays when what blocks is selected.
  int number_ = 0;                  ///< Of the document that is planned in.
  std::uint64_t planned_seed_ = 0;  ///< Of the plan that runs, or ended last.
  QString last_;                    ///< How the last plan ended.
  std::string blocker_;             ///< Name of the entity that blocks; empty: none.
  QLabel* name_;
  PlanGoalForm* goal_;
  /// What of the entity moves: a mannequin's hand, a robot's external axes.
  struct Moving {
    QComboBox* hand = nullptr;
    QWidget* hand_row = nullptr;
    QCheckBox* axes = nullptr;
    QWidget* axes_row = nullptr;
  } moving_;
  ThroughList* through_;
  ValueField *clearance_, *seed_, *time_;
  QPushButton *plan_, *stop_, *show_blocker_;
  QProgressBar* bar_;
  LiveLabel* says_;
};

}  // namespace hapticell::app
