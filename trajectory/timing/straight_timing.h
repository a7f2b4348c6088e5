// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace hapticell::trajectory {

/// The fastest motion along a straight line from rest to rest within a speed, an acceleration and a jerk. In each of up
/// to seven phases the jerk (or, without a jerk limit, the acceleration) is at its bound or zero (Biagiotti &
/// Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008, section 3.4). SI, all positive; the jerk
/// may be infinite.
class StraightTiming {
 public:
  StraightTiming(double way, double speed, double acceleration, double jerk = std::numeric_limits<double>::infinity());

  double duration() const { return 2.0 * gain_time_ + cruise_time_; }
  /// Path length at a time, clamped to the ends.
  double at(double t) const;

 private:
  /// Path length during acceleration, `t` after rest.
  double gained(double t) const;

  double way_, jerk_;
  double speed_ = 0.0;         ///< The greatest speed reached.
  double acceleration_ = 0.0;  ///< The greatest acceleration reached.
  double jerk_time_ = 0.0;     ///< Duration for which the acceleration grows, and later falls.
  double gain_time_ = 0.0;     ///< Duration from rest to speed_.
  double cruise_time_ = 0.0;
};

}  // namespace hapticell::trajectory
