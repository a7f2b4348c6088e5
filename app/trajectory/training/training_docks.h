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

/// The dock *Training* (dockTraining, hidden until it is asked for) and what its runs do in the window: the guide that
/// is felt and seen, the expert's ghost a little ahead, where the trainee is. GUI thread.
class TrainingDocks : public QObject {
  Q_OBJECT
 public:
  TrainingDocks(Host& host, MotionList& list, QObject* parent = nullptr);
  TrainingPanel& panel() { return *panel_; }
  /// Brings it to the front, unless something is held.
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
