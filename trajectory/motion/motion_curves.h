// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// One quantity of a motion over time, with its derivatives, as a chart shows it.
struct MotionCurve {
  std::string name;  ///< "x", "angle", a joint's.
  enum class Unit { kMetres, kRadians } unit = Unit::kMetres;
  /// Value and its first three time derivatives, one entry per sample.
  std::vector<double> value, speed, acceleration, jerk;
};

/// A motion as curves over evenly spaced times.
struct MotionCurves {
  double begin = 0.0, step = 0.0;  ///< s
  std::size_t samples = 0;
  std::vector<MotionCurve> cartesian;  ///< x, y, z (m), rotation about x, y, z since the start (rad).
  std::vector<MotionCurve> joints;
  MotionCurve path;  ///< Path length so far, m; its first derivative is the speed along the path.
  double timeOf(std::size_t i) const { return begin + step * static_cast<double>(i); }
};

/// At most `most` samples (four per frame, at least 240 where `most` allows it), with values between frames as from
/// poseAt(). The derivatives are those of the cubic that best fits the samples around each one (Savitzky & Golay,
/// Analytical Chemistry 36(8), 1964; window of 9), so that the jerk of a recording is readable and not only noise; the
/// third derivative at full rate is rmsJerk(). Fewer than two frames give no samples.
MotionCurves motionCurves(const Trajectory& trajectory, std::size_t most = 2000);

/// The largest absolute value of each order of a curve.
struct CurvePeaks {
  double speed = 0.0, acceleration = 0.0, jerk = 0.0;
};
CurvePeaks peaksOf(const MotionCurve& curve);

}  // namespace hapticell::trajectory
