// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "trajectory/motion/cubic_spline.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// A trajectory's frames as one cubic B-spline: position, quaternion (signs made continuous, unit after evaluation) and
/// joints, over any increasing parameter.
class MotionSpline {
 public:
  MotionSpline() = default;
  explicit MotionSpline(CubicSpline spline) : spline_(std::move(spline)) {}

  Pose pose(double u) const;
  std::vector<double> joints(double u) const;
  /// Third derivative of the position, per unit of u cubed.
  dvec3 jerk(double u) const;
  const CubicSpline& spline() const { return spline_; }

 private:
  CubicSpline spline_;
};

/// What a fit must keep to.
struct FitDemand {
  PathTolerance tolerance;             ///< Largest deviation at any frame.
  double joint_tolerance = 0.0174533;  ///< rad (m for slides), at any frame.
  /// Largest deviation (m, rad) of the frames' running mean over `mean_window` (in units of u): what a fit with too few
  /// spans leaves is no noise, it leans to one side. Infinity: not asked for.
  double mean_position = 1e300;
  double mean_angle = 1e300;
  double mean_window = 0.0;
  double first_span = 1.0;  ///< Spans begin with this length in u and are halved where needed.
};

/// Spans are halved until the demand holds or a span has no more than two frames. Ends are met exactly (to 1e-6 of the
/// tolerance), frames set by hand closely. @pre trajectory.size() == u.size() >= 2, u increasing.
MotionSpline fitMotion(const Trajectory& trajectory, std::span<const double> u, const FitDemand& demand);

/// The spline with a span from frame to frame, which passes every frame (to rounding) and bends as little as it may.
/// @pre as fitMotion()
MotionSpline splineThrough(const Trajectory& trajectory, std::span<const double> u);

}  // namespace hapticell::trajectory
