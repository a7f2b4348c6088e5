// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/viewport/scene/scene_model.h"
#include "trajectory/motion/playback.h"

namespace hapticell::app {

class Host;
class MotionList;

/// Plays the motions of the list that are switched on, all on one clock, in the scene: what is shown moves, the
/// document does not. It is true to the clock while ten pictures a second can be drawn, and slower, but as even, where
/// they cannot; no touch is passed over between two pictures. Panels that ask the scene where an entity stands
/// (SceneModel::placement_W, joints) follow. GUI thread.
class MotionPlayer : public QObject {
  Q_OBJECT
 public:
  MotionPlayer(Host& host, MotionList& list, QObject* parent = nullptr);
  ~MotionPlayer() override;

  const trajectory::Playback& playback() const { return playback_; }
  /// The scene shows the motions at the time; false: the cell as it stands.
  bool isShown() const { return shown_; }
  void setShown(bool on);
  void play();
  void pause();
  /// The machine draws fewer than ten pictures a second, so the play is slower than the motion was.
  bool isSlow() const;
  void seek(double time);
  void step(int direction);
  void setSpeed(double speed);
  void setLoop(bool on);
  /// Shows all places that the played motions go through at once, as ghosts: the room that they need.
  void setSwept(bool on);
  bool isSwept() const { return swept_; }
  /// What is played, and what hangs on it, where it is at a time.
  std::vector<GhostPose> playedAt(double time) const;

 signals:
  void changed();  ///< Time, play or pause, speed.

 private:
  void takeMotions();
  void tick();
  void show();
  void showSwept();
  Host& host_;
  MotionList& list_;
  trajectory::Playback playback_;
  QTimer timer_;
  QElapsedTimer clock_;
  double slow_s_ = 0.0;  ///< For so long pictures have come too seldom.
  bool shown_ = false, swept_ = false;
};

}  // namespace hapticell::app
