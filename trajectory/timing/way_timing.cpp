// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/way_timing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "trajectory/timing/straight_timing.h"
#include "trajectory/timing/time_optimal.h"

namespace hapticell::trajectory {

namespace {

/// Along a straight path the bound of a derivative is the tightest of its coordinates'.
double tightest(std::span<const double> change, const std::vector<double>& limits) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < limits.size() && j < change.size(); ++j)
    if (std::abs(change[j]) > 0.0) least = std::min(least, limits[j] / std::abs(change[j]));
  return least;
}

WayTiming straightTiming(const MotionPath& path, const MotionLimits& limits) {
  std::vector<double> first(path.dimensions()), second(path.dimensions());
  path.derivatives(0.0, first, second);
  const StraightTiming timing(path.breaks().back(), kFullUse * tightest(first, limits.velocity),
                              kFullUse * tightest(first, limits.acceleration), kFullUse * tightest(first, limits.jerk));
  return {timing.duration(), [timing](double t) { return timing.at(t); }};
}

/// A trapezoid of the frame's own speed along the path.
class SpeedTiming {
 public:
  SpeedTiming(const MotionPath& path, const RetimingOptions& options) {
    // Places where the run of the tool is summed up; at 1 m apart by 50 um. Half, twice: speed varies more or less
    // between; the check allows 0.1 %.
    constexpr std::size_t kPlaces = 20000;
    const double length = path.breaks().back();
    Pose before = path.pose(0.0);
    for (std::size_t i = 0; i <= kPlaces; ++i) {
      const double u = length * static_cast<double>(i) / static_cast<double>(kPlaces);
      const Pose X = path.pose(u);
      const PoseDistance step = distanceBetween(before, X);
      const double way = std::hypot(step.position, options.metres_per_radian * step.angle);
      before = X;
      if (i > 0 && !(way > 0.0)) continue;
      places_.push_back(u);
      runs_.push_back(runs_.empty() ? 0.0 : runs_.back() + way);
    }
    places_.back() = length;
  }
  double length() const { return runs_.back(); }
  double placeAt(double run) const {
    const auto after = std::upper_bound(runs_.begin() + 1, runs_.end() - 1, run);
    const auto i = static_cast<std::size_t>(after - runs_.begin()) - 1;
    const double share = std::clamp((run - runs_[i]) / (runs_[i + 1] - runs_[i]), 0.0, 1.0);
    return places_[i] + share * (places_[i + 1] - places_[i]);
  }

 private:
  std::vector<double> places_, runs_;
};

}  // namespace

WayTiming WayTiming::slower(double factor) const {
  return {factor * duration, [way = way, factor](double t) { return way(t / factor); }};
}

Expected<WayTiming> wayTimingOf(const MotionPath& path, const RetimingOptions& options) {
  if (options.mode == TimingMode::kConstantSpeed) {
    auto runs = std::make_shared<const SpeedTiming>(path, options);
    const StraightTiming timing(runs->length(), options.speed, options.acceleration);
    return WayTiming{timing.duration(), [runs, timing](double t) { return runs->placeAt(timing.at(t)); }};
  }
  if (path.isStraight()) return straightTiming(path, options.limits);
  auto timing = options.limits.jerk.empty() ? timeOptimal(path, options.limits, {options.grid_points})
                                            : jerkLimited(path, options.limits, {options.grid_points});
  HAPTICELL_TRY(timing);
  return WayTiming{timing->duration(), [timing = std::move(*timing)](double t) { return timing.at(t).s; }};
}

}  // namespace hapticell::trajectory
