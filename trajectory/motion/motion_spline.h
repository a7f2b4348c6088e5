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
  /// Third derivative of the position by u.
  dvec3 jerk(double u) const;
  const CubicSpline& spline() const { return spline_; }

 private:
  CubicSpline spline_;
};

/// Conditions that a fit must meet.
struct FitDemand {
  PathTolerance tolerance;             ///< Largest deviation at any frame.
  double joint_tolerance = 0.0174533;  ///< rad (m for slides), at any frame.
  /// Largest deviation (m, rad) of the running mean of the frames over `mean_window` (in units of u). A fit with too
  /// few spans leaves a deviation with a bias to one side, which noise does not have. Infinity: not required.
  double mean_position = 1e300;
  double mean_angle = 1e300;
  double mean_window = 0.0;
  double first_span = 1.0;  ///< Initial length of the spans in u; spans are halved where needed.
};

/// Spans are halved until the condition holds or a span has at most two frames. Both ends are met exactly (to 1e-6 of
/// the tolerance), frames set by hand closely.
/// @pre trajectory.size() == u.size() >= 2, u increasing.
MotionSpline fitMotion(const Trajectory& trajectory, std::span<const double> u, const FitDemand& demand);

/// The spline with one span between each two frames, which passes through every frame (to rounding) with the least
/// bending.
/// @pre as fitMotion()
MotionSpline splineThrough(const Trajectory& trajectory, std::span<const double> u);

}  // namespace hapticell::trajectory
