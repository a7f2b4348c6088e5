// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>
#include <utility>
#include <vector>

#include "manipulation/engine/manipulation_command.h"
#include "workcell/entity/guide.h"

namespace hapticell::app {

/// Between who wants to record (the trajectory panel, keys) and who moves (a module's loop, or the window itself while
/// no module runs). GUI thread.
class RecordingHub : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// A module's loop takes the orders from now on and delivers what was recorded; false: the window does.
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
  /// What was recorded comes by recorded(), soon.
  void stop() {
    recording_ = false;
    emit stopWanted();
  }
  /// Another document follows: what is being recorded is not kept.
  void abandon() {
    setGuide(std::nullopt);
    if (!recording_) return;
    abandoned_ = true;
    stop();
  }
  /// A frame by hand, here and now; nothing while nothing is recorded.
  void mark() {
    if (recording_) emit markWanted();
  }
  /// A guide beside those of the document, felt by what is held: a training's. Nothing: none.
  void setGuide(const std::optional<workcell::Guide>& guide) {
    guide_ = guide;
    emit guideWanted();
  }
  const std::optional<workcell::Guide>& guide() const { return guide_; }
  /// Of the one who moves.
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
