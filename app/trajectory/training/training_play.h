// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

#include "manipulation/checks/motion_replay.h"

namespace hapticell::app {

class Host;

/// Shows an exercise's motions in the scene in real time: the expert's alone, by the part itself; or the trainee's run
/// by the part and the expert's as a ghost beside it, both from their beginnings. The document stays as it is. GUI
/// thread.
class TrainingPlay : public QObject {
  Q_OBJECT
 public:
  explicit TrainingPlay(Host& host, QObject* parent = nullptr);

  /// Begins from the start; what was played ends. An empty `run`: the expert alone. Errors: the cell has nothing that
  /// could move so; then nothing is played.
  Expected<void> play(const trajectory::Trajectory& expert, const trajectory::Trajectory& run);
  /// The scene shows the cell as it is again. Harmless when nothing is played.
  void stop();
  bool isPlaying() const { return expert_ != nullptr; }

 signals:
  void ended();

 private:
  void show();
  Host& host_;
  std::unique_ptr<const manipulation::MotionReplay> expert_, run_;
  double seconds_ = 0.0;  ///< Of the longer one.
  QElapsedTimer clock_;
  QTimer timer_;
};

}  // namespace hapticell::app
