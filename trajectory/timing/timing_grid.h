// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {

/// With x = (ds/dt)^2 and u = d2s/dt2 each bound on acceleration is -m <= a u + b x <= m.
struct BoundRow {
  double a, b, m;
};

/// u between lines of x: lower <= u <= upper.
struct BoundLine {
  double constant, slope;
  double at(double x) const { return constant + slope * x; }
};

/// All that bounds (u, x) at one grid point.
struct TimingStage {
  std::vector<BoundLine> lower, upper;
  double x_most = std::numeric_limits<double>::infinity();

  void clear();  ///< The lines; x_most stays.
  void add(const BoundRow& row);
};

/// Where a path is looked at for its timing: even steps and the path's own breaks, with its derivatives there and half
/// way between, so that nothing is evaluated again. `limits` must outlive it. One thread.
class TimingGrid {
 public:
  /// `points`: at least 3, without the breaks.
  TimingGrid(const LimitedPath& path, const MotionLimits& limits, std::size_t points);
  /// The same places of the path under other limits.
  TimingGrid(const TimingGrid& other, const MotionLimits& limits)
      : limits_(limits), dimensions_(other.dimensions_), s_(other.s_), first_(other.first_), second_(other.second_) {}

  /// At any s, from the places known: see useBetween().
  void derivatives(double s, std::span<double> first, std::span<double> second) const;

  std::size_t dimensions() const { return dimensions_; }
  std::size_t size() const { return s_.size(); }
  double step(std::size_t i) const { return s_[i + 1] - s_[i]; }
  const std::vector<double>& s() const { return s_; }

  /// Velocity bounds x; velocity and acceleration are bounded here, half way and at the end of the step that begins
  /// here: at a part w of the step x' = x + 2 w step u.
  void fill(std::size_t i, TimingStage& stage) const;

  /// Of x = (ds/dt)^2 at half step k.
  double speedBound(std::size_t k) const;

  /// Largest share of the limits on velocity and acceleration between the grid points, where these speeds are had at
  /// them. Within a step the path is a cubic, or nearly one: its first derivative is the parabola through the three
  /// places known, its second a line.
  LimitUse useBetween(const std::vector<double>& speeds) const;

 private:
  void layGrid(const LimitedPath& path, std::size_t points);

  const MotionLimits& limits_;
  std::size_t dimensions_ = 0;
  std::vector<double> s_;
  std::vector<double> first_, second_;  ///< dq/ds and d2q/ds2 at every half step.
};

}  // namespace hapticell::trajectory
