// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace hapticell::trajectory {

/// State of playing one or more motions on one clock: time, direction, speed, loop. It has no clock: the caller passes
/// the elapsed time. A value.
class Playback {
 public:
  /// Times (s, increasing) at which the motions have frames, merged into one list; playing runs from the first to the
  /// last. The present time is kept if it is still inside.
  void setFrames(std::vector<double> times);
  /// Times (s) at which playing must stop for one picture, so that events shorter than a picture (a touch) are seen.
  /// The delay is made up afterwards.
  void setStops(std::vector<double> times);

  double time() const { return time_; }
  double begin() const { return frames_.empty() ? 0.0 : frames_.front(); }
  double end() const { return frames_.empty() ? 0.0 : frames_.back(); }
  bool isPlaying() const { return playing_; }
  bool loops() const { return loops_; }
  double speed() const { return speed_; }

  /// Starts; at the end, starts from the beginning. Does nothing without frames.
  void play();
  void pause() { playing_ = false; }
  /// Jumps to this time (clamped); continues to play if it was playing.
  void seek(double time);
  /// Jumps to the next or previous frame of any motion; stops playing.
  void step(int direction);
  /// Factor of the recorded speed, above 0 (values below 0.01 are taken as 0.01).
  void setSpeed(double speed);
  void setLoop(bool on) { loops_ = on; }
  /// Advances by `seconds` of the user's time. Returns true if something changed. At the end it stops or, in a loop,
  /// starts again.
  bool advance(double seconds);

 private:
  /// The first stop after `from`, up to `to`; `to` if there is no stop.
  double stopBetween(double from, double to) const;
  std::vector<double> frames_, stops_;
  double time_ = 0.0, speed_ = 1.0;
  double owed_ = 0.0;  ///< s of the user's time lost by a stop, at most one step.
  bool playing_ = false, loops_ = false;
};

}  // namespace hapticell::trajectory
