// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/robot/configuration_model.h"

class QLabel;
class QPushButton;
class QTableView;

namespace hapticell::app {

class JointMover;
class MotionWorker;
class RobotContext;

/// "Choose configuration": all ways to hold the tool where it is, with a ghost of the row under the mouse or the chosen
/// row in the scene, and the button that moves there.
class ConfigurationView : public QWidget {
  Q_OBJECT
 public:
  ConfigurationView(RobotContext& context, MotionWorker& worker, JointMover& mover, QWidget* parent = nullptr);
  ConfigurationModel& model() { return model_; }
  /// Moves to the chosen row.
  void take();

 signals:
  void listed();  ///< A new list is shown.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void askAgain();
  void show(std::vector<kinematics::ListedSolution> solutions);
  void showGhost();
  void showStale();
  void showFoot();
  int shownRow() const;  ///< The hovered row, else the chosen one; -1: none.
  RobotContext& context_;
  MotionWorker& worker_;
  JointMover& mover_;
  ConfigurationModel model_;
  QLabel *count_, *foot_;
  QTableView* table_;
  QPushButton* take_;
  QTimer ask_;
  int hovered_ = -1;
  workcell::EntityId asked_robot_ = 0;  ///< That the list is of.
  std::vector<double> asked_, keep_;  ///< Joints that the list is for; the chosen solution.
};

}  // namespace hapticell::app
