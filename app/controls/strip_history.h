// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// One moment of the strip chart.
struct StripSample {
  double time_s = 0.0;
  double gap_m = 0.0;  ///< NaN while unknown.
  double force_n = 0.0;
  bool contact = false;
  bool near_miss = false;
  double haptic_hz = 0.0, manipulation_hz = 0.0;  ///< Lowest of the merged samples.
};

/// Clearance and force over the last seconds, oldest first. Samples closer together than the width of a pixel are
/// merged so that the smallest clearance and the greatest force are kept. A value; GUI thread.
class StripHistory {
 public:
  explicit StripHistory(double length_s = 20.0, double step_s = 0.025) : length_s_(length_s), step_s_(step_s) {}
  /// Adds a snapshot. If it has the same time as the last one, it is ignored; if it is older, the history restarts (a
  /// new loop).
  void add(const manipulation::SceneSnapshot& snapshot);
  void clear() { samples_.clear(); }
  const std::deque<StripSample>& samples() const { return samples_; }
  double length() const { return length_s_; }
  /// Time of the newest sample, seconds; 0 when empty.
  double now() const { return samples_.empty() ? 0.0 : samples_.back().time_s; }
  /// The sample nearest to a time; null when empty.
  const StripSample* at(double time_s) const;

 private:
  std::deque<StripSample> samples_;
  double length_s_, step_s_;
};

/// The top of an axis that shows `value`: 1, 2 or 5 times a power of ten, at least `least`.
double axisTop(double value, double least);

}  // namespace hapticell::app
