// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/error.h"
#include "trajectory/cubic_spline.h"

namespace hapticell::trajectory {

/// Bounds for each dimension of a path, all positive: per second, per second squared.
struct MotionLimits {
  std::vector<double> velocity;
  std::vector<double> acceleration;
  /// Per second cubed; empty: jerk is free.
  std::vector<double> jerk;
};

/// Where on a path a motion is at each time: s with constant acceleration between grid points.
class PathTiming {
 public:
  PathTiming() = default;
  /// `s` strictly increasing, `speed` = ds/dt at each, not both zero at neighbours.
  PathTiming(std::vector<double> s, std::vector<double> speed);

  double duration() const { return t_.empty() ? 0.0 : t_.back(); }
  struct State {
    double s = 0.0, speed = 0.0, acceleration = 0.0;
  };
  State at(double t) const;  ///< Clamped to the ends.
  const std::vector<double>& grid() const { return s_; }
  const std::vector<double>& speeds() const { return speed_; }

 private:
  std::vector<double> s_, speed_, t_;
};

struct TimingOptions {
  std::size_t grid_points = 1000;
  double start_speed = 0.0, end_speed = 0.0;  ///< ds/dt
};

/// The fastest motion along the path within the limits on velocity and acceleration: reachability analysis over the
/// grid, backwards for the speeds from which the end can be met, then forwards as fast as they allow (Pham & Pham, "A
/// new approach to time-optimal path parameterization based on reachability analysis", IEEE T-RO 34(3), 2018).
/// Acceleration is bounded at both ends of each grid step. Errors: a path of no length, limits that are not positive, a
/// start or end speed that no motion can have.
Expected<PathTiming> timeOptimal(const CubicSpline& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});

/// The same slowed so that the jerk keeps its limits as well: the speed profile is averaged over a window of time and
/// the whole stretched until every limit holds; the window with the shortest result is taken. Near the optimum, not on
/// it.
Expected<PathTiming> jerkLimited(const CubicSpline& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});

/// Largest share of each limit that the motion uses, by sampling (1 is the limit).
struct LimitUse {
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
};
LimitUse limitUse(const CubicSpline& path, const PathTiming& timing, const MotionLimits& limits, double dt);

}  // namespace hapticell::trajectory
