// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QVBoxLayout;

namespace hapticell::app {

class RobotContext;
class Segmented;

/// What the hand holds of the robot: its tool or its base, which tool, whether the external axes that carry it move
/// along, and what yields at a singularity.
class HoldingView : public QWidget {
  Q_OBJECT
 public:
  explicit HoldingView(RobotContext& context, QWidget* parent = nullptr);
  /// Shows the newest choices and tools.
  void showNow();
  /// Allows a choice of tools only while the robot is neither held nor locked.
  void setFree(bool free);

 signals:
  void toolsWanted();

 private:
  void addSingularity(QVBoxLayout& rows);
  void showTools();
  void showAxes();
  void showSingularity();
  RobotContext& context_;
  Segmented* held_by_;
  QComboBox *tool_, *singularity_;
  QCheckBox* axes_;
  QWidget* axes_row_;
};

}  // namespace hapticell::app
