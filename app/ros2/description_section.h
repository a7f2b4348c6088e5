// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/ros2/ros2_process.h"

class QPushButton;

namespace hapticell::app {

class Host;
class LiveLabel;
class Ros2Network;
class Ros2Topics;
class TopicChoice;

/// Takes the description of a robot that another program publishes: it is kept as a file, and the window imports that
/// like any URDF. GUI thread.
class DescriptionSection : public QWidget {
  Q_OBJECT
 public:
  DescriptionSection(Host& host, const Ros2Network& network, const Ros2Topics& topics, QWidget* parent = nullptr);
  /// Waits for the description of the chosen topic and writes it to `path`; then received().
  void importTo(const QString& path);

 signals:
  void received(const QString& path);  ///< A description is in this file, to be imported.

 private:
  void ask();
  void finish(const QJsonObject& result, const QString& sentence);
  void show();

  Host& host_;
  const Ros2Network& network_;
  Ros2Process process_;
  TopicChoice* topic_;
  QPushButton* import_;
  LiveLabel* line_;
  QString path_, says_;
};

}  // namespace hapticell::app
