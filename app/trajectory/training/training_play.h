// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

#include "manipulation/checks/motion_replay.h"

namespace hapticell::app {

class Host;

/// Plays an exercise's motions in the scene in real time: the expert's alone, with the part itself; or the trainee's
/// run with the part and the expert's with a ghost, both from their beginnings. The document does not change. GUI
/// thread.
class TrainingPlay : public QObject {
  Q_OBJECT
 public:
  explicit TrainingPlay(Host& host, QObject* parent = nullptr);

  /// Plays from the start, and ends an earlier playback. An empty `run`: the expert alone. Error: the cell has no
  /// entity for this motion; then nothing is played.
  Expected<void> play(const trajectory::Trajectory& expert, const trajectory::Trajectory& run);
  /// Shows the cell at rest again. Does nothing if nothing is played.
  void stop();
  bool isPlaying() const { return expert_ != nullptr; }

 signals:
  void ended();

 private:
  void show();
  Host& host_;
  std::unique_ptr<const manipulation::MotionReplay> expert_, run_;
  double seconds_ = 0.0;  ///< Duration of the longer one.
  QElapsedTimer clock_;
  QTimer timer_;
};

}  // namespace hapticell::app
