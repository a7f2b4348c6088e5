// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/cubic_spline.h"
#include "trajectory/timing/path_timing.h"

namespace hapticell::trajectory {

/// Bounds for each dimension of a path, all positive: per second, per second squared.
struct MotionLimits {
  std::vector<double> velocity;
  std::vector<double> acceleration;
  /// Per second cubed; empty: no jerk limit.
  std::vector<double> jerk;
};

/// A path whose coordinates are limited, with derivatives by its parameter s.
class LimitedPath {
 public:
  virtual ~LimitedPath() = default;
  virtual std::size_t dimensions() const = 0;
  /// Begin and end of s and, between them, where the second derivative may kink; strictly increasing.
  virtual const std::vector<double>& breaks() const = 0;
  /// dimensions() numbers each.
  virtual void derivatives(double s, std::span<double> first, std::span<double> second) const = 0;
};

/// A spline whose every dimension is limited.
class LimitedSpline : public LimitedPath {
 public:
  explicit LimitedSpline(const CubicSpline& spline) : spline_(spline) {}
  std::size_t dimensions() const override { return spline_.dimensions(); }
  const std::vector<double>& breaks() const override { return spline_.breaks(); }
  void derivatives(double s, std::span<double> first, std::span<double> second) const override {
    spline_.evaluate(s, 1, first);
    spline_.evaluate(s, 2, second);
  }

 private:
  const CubicSpline& spline_;
};

struct TimingOptions {
  std::size_t grid_points = 1000;
  double start_speed = 0.0, end_speed = 0.0;  ///< ds/dt
};

/// The fastest motion along the path within the limits on velocity and acceleration: reachability analysis over the
/// grid, backward for the speeds from which the end can be reached, then forward as fast as they allow (Pham & Pham, "A
/// new approach to time-optimal path parameterization based on reachability analysis", IEEE T-RO 34(3), 2018).
/// Acceleration is bounded at both ends of each grid step. Errors: a path without length, limits that are not positive,
/// a start or end speed that no motion can have.
Expected<PathTiming> timeOptimal(const LimitedPath& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});
Expected<PathTiming> timeOptimal(const CubicSpline& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});

/// The same, slowed so that the jerk limits hold as well, however small they are: the motion is averaged over a time
/// window and stretched until every limit holds; of several windows and speeds the shortest result is taken. Near the
/// optimum, not optimal (StraightTiming is, for a straight path). From rest to rest.
Expected<PathTiming> jerkLimited(const LimitedPath& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});
Expected<PathTiming> jerkLimited(const CubicSpline& path, const MotionLimits& limits,
                                 const TimingOptions& options = {});

/// The largest share of each limit that the motion uses, by sampling (1 is the limit).
struct LimitUse {
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
};
LimitUse limitUse(const CubicSpline& path, const PathTiming& timing, const MotionLimits& limits, double dt);

/// The common checks of limits: a positive velocity and acceleration and, optionally, a positive jerk for each
/// dimension. Errors: one is missing or not positive.
Expected<void> checkLimits(std::size_t dimensions, const MotionLimits& limits);

/// The factor by which the motion must be slowed so that all limits hold; at least 1.
double stretchFor(const LimitUse& use);

}  // namespace hapticell::trajectory
