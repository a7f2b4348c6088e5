// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "kinematics/model/jog.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace hapticell::app {

class CartesianJog;
class ConfigurationView;
class HoldingView;
class JointJog;
class JointMover;
class MotionWorker;
class RobotContext;
class RobotThumbnail;
class Segmented;
class RobotStop;

/// The robot's dock: what the hand holds of it, its tool, its configurations, its joints, and why it stops. For a
/// mechanism, only the joints.
class RobotPanel : public QWidget {
  Q_OBJECT
 public:
  RobotPanel(RobotContext& context, MotionWorker& worker, JointMover& mover, QWidget* parent = nullptr);
  /// Shows the newest numbers; called ten times a second.
  void showNow();
  /// Shows why a dragged arm does not follow; empty: it follows.
  void showHeldBack(const QString& why);
  ConfigurationView& configurations() { return *configurations_; }

 signals:
  void toolsWanted();
  void libraryWanted();
  void mechanismWanted();
  /// The Cartesian tab was shown or hidden: its gizmo follows.
  void cartesianShown(bool shown);
  /// `R_WF`: the present axes of the frame.
  void jogFrameChosen(kinematics::JogFrame frame, const hapticell::dquat& R_WF);

 private:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void emitShownTab();
  void addEmptyState(QVBoxLayout& column);
  void addHeading(QVBoxLayout& column);
  void addHolding(QVBoxLayout& column);
  void addJog(QVBoxLayout& column);
  void addMechanism(QVBoxLayout& column);
  void showRobot();
  void showStop();
  void showStep();
  void choosePose(const QString& name);
  void fillPoses();
  void keepPose();
  RobotContext& context_;
  JointMover& mover_;
  QWidget *empty_, *content_, *holding_, *choosing_, *mechanism_;
  QLabel *name_, *kind_;
  HoldingView* held_;
  RobotThumbnail* picture_;
  Segmented* tabs_;
  QComboBox* step_;
  QStackedWidget* jogs_;
  QPushButton *home_, *poses_;
  JointJog* joints_;
  CartesianJog* cartesian_;
  ConfigurationView* configurations_;
  RobotStop* stop_;
};

}  // namespace hapticell::app
