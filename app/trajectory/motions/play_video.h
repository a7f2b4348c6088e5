// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QSize>
#include <QTimer>
#include <memory>

#include "geometry/system/error.h"

namespace hapticell::app {

class Host;
class MotionPlayer;

/// A video of what the player plays, from its beginning to its end at the player's speed, with the view at the start.
/// Drawn frame by frame, so that the window stays responsive. One at a time. GUI thread.
class PlayVideo : public QObject {
  Q_OBJECT
 public:
  PlayVideo(Host& host, const MotionPlayer& player, QObject* parent = nullptr);
  ~PlayVideo() override;

  /// Error: nothing to play, no ffmpeg, or a file that cannot be written. Emits ended() later.
  Expected<void> start(const QString& file, const QSize& size);
  /// Cancels; no file is written.
  void cancel();
  bool isBusy() const { return work_ != nullptr; }
  double share() const;

 signals:
  void stepped();
  void ended(const QString& file, const QString& problem);  ///< If `problem` is empty, the file exists.

 private:
  struct Work;
  void step();
  Host& host_;
  const MotionPlayer& player_;
  QTimer timer_;
  std::unique_ptr<Work> work_;
};

}  // namespace hapticell::app
