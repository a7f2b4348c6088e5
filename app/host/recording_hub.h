// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>
#include <utility>
#include <vector>

#include "manipulation/engine/manipulation_command.h"
#include "workcell/entity/guide.h"

namespace hapticell::app {

/// Connects who wants to record (the trajectory panel, keys) with who moves (a module's loop, or the window itself
/// while no module runs). GUI thread.
class RecordingHub : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// True: a module's loop takes the orders from now on and delivers the recordings; false: the window does.
  void setLive(bool live) {
    if (live == live_) return;
    if (recording_) stop();
    live_ = live;
    emit liveChanged(live);
  }
  bool isLive() const { return live_; }
  bool isRecording() const { return recording_; }

  void start(const manipulation::command::StartRecording& wanted) {
    recording_ = true;
    emit startWanted(wanted);
  }
  /// Stops recording; recorded() delivers the result soon after.
  void stop() {
    recording_ = false;
    emit stopWanted();
  }
  /// Drops the running recording, because another document follows.
  void abandon() {
    setGuide(std::nullopt);
    if (!recording_) return;
    abandoned_ = true;
    stop();
  }
  /// Records a frame here and now; does nothing while nothing is recorded.
  void mark() {
    if (recording_) emit markWanted();
  }
  /// Sets a guide in addition to the document's, felt by what is held: for training. Empty: none.
  void setGuide(const std::optional<workcell::Guide>& guide) {
    guide_ = guide;
    emit guideWanted();
  }
  const std::optional<workcell::Guide>& guide() const { return guide_; }
  /// Called by whoever moves: delivers recorded trajectories.
  void deliver(const std::vector<trajectory::Trajectory>& trajectories) {
    recording_ = false;
    if (std::exchange(abandoned_, false)) return;
    emit recorded(trajectories);
  }

 signals:
  void startWanted(const hapticell::manipulation::command::StartRecording& wanted);
  void stopWanted();
  void markWanted();
  void guideWanted();
  void liveChanged(bool live);
  void recorded(const std::vector<hapticell::trajectory::Trajectory>& trajectories);

 private:
  bool live_ = false, recording_ = false, abandoned_ = false;
  std::optional<workcell::Guide> guide_;
};

}  // namespace hapticell::app
