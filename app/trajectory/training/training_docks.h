// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "manipulation/checks/motion_replay.h"
#include "workcell/entity/guide.h"

class QDockWidget;

namespace hapticell::app {

class Host;
class MotionList;
class TrainingPanel;

/// The dock *Training* (dockTraining, hidden until it is opened), and what its runs do in the window: the guide that is
/// felt and shown, the expert's ghost a little ahead, the trainee's position. GUI thread.
class TrainingDocks : public QObject {
  Q_OBJECT
 public:
  TrainingDocks(Host& host, MotionList& list, QObject* parent = nullptr);
  TrainingPanel& panel() { return *panel_; }
  /// Brings the dock to the front, unless something is held.
  void open();

 private:
  void showGuide(const std::optional<workcell::Guide>& guide);
  void openCell(const QString& path);
  void follow();
  Host& host_;
  TrainingPanel* panel_;
  QDockWidget* dock_;
  QTimer timer_;
  std::shared_ptr<const manipulation::MotionReplay> expert_;
};

}  // namespace hapticell::app
