// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/system/error.h"
#include "trajectory/timing/motion_path.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::trajectory {

/// Of the limits: numbers are rounded when they are written, and the check allows 1.001. Half the distance to 1:
/// written files may fail; twice: 0.05 % slower.
inline constexpr double kFullUse = 0.9995;

/// Where a motion is on its path by time.
struct WayTiming {
  double duration = 0.0;              ///< s
  std::function<double(double)> way;  ///< The path's parameter at a time (s), from its begin to its end.

  /// The same, `factor` times as long.
  WayTiming slower(double factor) const;
};

/// The timing of a path by the mode of the options, from rest to rest: a trapezoid of the tool's speed, or as fast as
/// the limits allow. The result refers to `path`. Errors: see timeOptimal() and jerkLimited().
Expected<WayTiming> wayTimingOf(const MotionPath& path, const RetimingOptions& options);

}  // namespace hapticell::trajectory
