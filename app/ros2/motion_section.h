// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/ros2/cell_copy.h"
#include "app/ros2/ros2_process.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace hapticell::app {

class Host;
class LiveLabel;
class Ros2Network;
class ValueField;

/// Sends a kept motion to a robot's controller: it is checked by hapticell-ros2, shown with robot, duration and speed,
/// and moves the robot only after the user confirmed exactly that. GUI thread.
class MotionSection : public QWidget {
  Q_OBJECT
 public:
  MotionSection(Host& host, const Ros2Network& network, QWidget* parent = nullptr);

 private:
  void check();
  void ask(const QJsonObject& preview);
  void take(const QJsonObject& line);
  void finish(const QJsonObject& result, const QString& sentence);
  void show();

  Host& host_;
  const Ros2Network& network_;
  Ros2Process process_;
  CellCopy copy_;
  QComboBox* motion_;
  QLineEdit* action_;
  ValueField* speed_;
  QPushButton *send_, *stop_;
  LiveLabel* line_;
  QJsonObject job_;
  QString says_;
};

}  // namespace hapticell::app
