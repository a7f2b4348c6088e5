// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace hapticell::trajectory {

/// State of playing one or more motions on one clock: time, direction of steps, speed, loop. It has no clock: the
/// caller passes the elapsed time. A value.
class Playback {
 public:
  /// Times (s, increasing) at which the motions have frames, all in one list; the play runs from the first to the last.
  /// The time is kept where it is still inside.
  void setFrames(std::vector<double> times);
  /// Times (s) that no step of the play passes over: it stops there for a picture and makes the time up afterwards. So
  /// what lasts less than a picture (a touch) is seen.
  void setStops(std::vector<double> times);

  double time() const { return time_; }
  double begin() const { return frames_.empty() ? 0.0 : frames_.front(); }
  double end() const { return frames_.empty() ? 0.0 : frames_.back(); }
  bool isPlaying() const { return playing_; }
  bool loops() const { return loops_; }
  double speed() const { return speed_; }

  /// Starts; if it is at the end, it starts from the beginning. Does nothing without frames.
  void play();
  void pause() { playing_ = false; }
  /// Goes there (clamped), playing on if it played.
  void seek(double time);
  /// To the next frame (of any motion) after the time, or the one before; stops the play.
  void step(int direction);
  /// Factor of the recorded time, above 0 (smaller ones are taken as 0.01).
  void setSpeed(double speed);
  void setLoop(bool on) { loops_ = on; }
  /// Advances by `seconds` of the user's time. Returns true if something changed; at the end it stops, or starts again.
  bool advance(double seconds);

 private:
  /// The first stop after `from`, up to `to`; `to` if there is no stop.
  double stopBetween(double from, double to) const;
  std::vector<double> frames_, stops_;
  double time_ = 0.0, speed_ = 1.0;
  double owed_ = 0.0;  ///< s of the user's time that a stop has cost, at most one step's.
  bool playing_ = false, loops_ = false;
};

}  // namespace hapticell::trajectory
