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

/// Plays the motions of the list that are switched on, on one clock, in the scene: only what is shown moves, the
/// document does not change. Keeps up with the clock while ten frames a second can be drawn; otherwise plays slower but
/// evenly. No contact between two frames is skipped. Panels that ask the scene for an entity's pose
/// (SceneModel::placement_W, joints) follow. GUI thread.
class MotionPlayer : public QObject {
  Q_OBJECT
 public:
  MotionPlayer(Host& host, MotionList& list, QObject* parent = nullptr);
  ~MotionPlayer() override;

  const trajectory::Playback& playback() const { return playback_; }
  /// True while the scene shows the motions at time(); false: the cell at rest.
  bool isShown() const { return shown_; }
  void setShown(bool on);
  void play();
  void pause();
  /// True if the machine draws fewer than ten frames a second, so that playback is slower than the motion.
  bool isSlow() const;
  void seek(double time);
  void step(int direction);
  void setSpeed(double speed);
  void setLoop(bool on);
  /// Shows the swept volume of the played motions: all their poses at once, as ghosts.
  void setSwept(bool on);
  bool isSwept() const { return swept_; }
  /// What is played, and what is attached to it, at a time.
  std::vector<GhostPose> playedAt(double time) const;

 signals:
  void changed();  ///< Time, play or pause, or speed changed.

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
  double slow_s_ = 0.0;  ///< For how long frames have been too slow.
  bool shown_ = false, swept_ = false;
};

}  // namespace hapticell::app
