// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace hapticell::trajectory {

/// The place on a path at each time: s with constant acceleration between grid points; or the mean of that over a time
/// window, which bounds the jerk: the acceleration is then continuous and the motion takes longer by the window.
class PathTiming {
 public:
  PathTiming() = default;
  /// `s` strictly increasing, `speed` = ds/dt at each, not both zero at neighbours.
  PathTiming(std::vector<double> s, std::vector<double> speed);

  /// The same, averaged over `window` seconds, if it is not already.
  PathTiming averaged(double window) const;
  /// The same, slower by `factor`.
  PathTiming stretched(double factor) const;

  double duration() const { return t_.empty() ? 0.0 : stretch_ * (t_.back() + window_); }
  struct State {
    double s = 0.0, speed = 0.0, acceleration = 0.0;
  };
  State at(double t) const;  ///< Clamped to the ends.

 private:
  State plainAt(double t) const;
  /// Integral of s over time from the start. Longer than a double, because a window is a small difference of two such
  /// values.
  long double integralTo(double t) const;

  std::vector<double> s_, speed_, t_;
  std::vector<long double> integral_;
  double window_ = 0.0, stretch_ = 1.0;
};

}  // namespace hapticell::trajectory
