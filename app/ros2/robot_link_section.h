// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/ros2/cell_copy.h"
#include "app/ros2/ros2_process.h"
#include "workcell/entity/entity.h"

class QComboBox;
class QPushButton;

namespace hapticell::app {

class Host;
class LiveLabel;
class Ros2Network;
class Ros2Topics;
class Segmented;
class TopicChoice;

/// Publishes a robot of the cell as it moves in the window, or lets it follow the joint states of another program. What
/// it follows is a trial: the cell changes only by *Keep pose*. GUI thread.
class RobotLinkSection : public QWidget {
  Q_OBJECT
 public:
  RobotLinkSection(Host& host, const Ros2Network& network, Ros2Topics& topics, QWidget* parent = nullptr);

 private:
  void toggle();
  void begin();
  void sendPose();
  void take(const QJsonObject& line);
  void takeHeard(const QJsonArray& joints);
  void keepPose();
  void finish(const QString& sentence);
  void show();
  bool isMirror() const;

  Host& host_;
  const Ros2Network& network_;
  Ros2Topics& topics_;
  Ros2Process process_;
  CellCopy copy_;
  QTimer timer_;
  QComboBox* robot_;
  Segmented* way_;
  TopicChoice* joints_;
  QPushButton *start_, *keep_;
  LiveLabel* line_;
  workcell::EntityId entity_ = 0;
  std::vector<double> heard_;
  QString figures_, problem_;
  bool mirrors_ = false;
};

}  // namespace hapticell::app
