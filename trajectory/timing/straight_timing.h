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
  /// Way run at a time, clamped to the ends.
  double at(double t) const;

 private:
  /// Way run while speed is gained, `t` after rest.
  double gained(double t) const;

  double way_, jerk_;
  double speed_ = 0.0;         ///< That is reached.
  double acceleration_ = 0.0;  ///< Likewise.
  double jerk_time_ = 0.0;     ///< The acceleration grows, and falls again, for so long.
  double gain_time_ = 0.0;     ///< From rest to speed_.
  double cruise_time_ = 0.0;
};

}  // namespace hapticell::trajectory
