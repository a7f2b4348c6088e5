// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

struct SmoothingOptions {
  PathTolerance tolerance{};
};

/// Hand tremor: the motion around 9 Hz that remains after a curve of second degree is fitted over a quarter of a
/// second.
struct Tremor {
  double position = 0.0;  ///< rms, m.
  double angle = 0.0;     ///< rms, rad.
};

struct SmoothingReport {
  PoseDistance max_deviation{};  ///< The largest over all recorded frames.
  double rms_deviation = 0.0;    ///< m
  Tremor tremor{};
  /// The tolerance is smaller than the tremor: smoothing cannot remove the tremor and keep the tolerance.
  bool tremor_exceeds_tolerance = false;
  double rms_jerk_before = 0.0;  ///< m/s3, by third differences of the recording.
  double rms_jerk_after = 0.0;   ///< m/s3, of the spline.
  std::size_t spans = 0;
  /// Frames that no spline passed within the tolerance: they were moved to its edge.
  std::size_t frames_drawn_back = 0;
};

/// A copy with the same times, on a cubic spline through position, orientation and joints. It has as few spans as keep
/// every frame within the tolerance and the running mean unbiased, so that tremor is removed and the path is kept. The
/// few frames that no spline passes within the tolerance (sharp corners) are moved to its edge. Poses and joints are
/// smoothed separately and marked so. A trajectory with fewer than four frames is returned unchanged.
struct Smoothed {
  Trajectory trajectory;
  SmoothingReport report;
};
Smoothed smoothed(const Trajectory& trajectory, const SmoothingOptions& options = {});

Tremor estimateTremor(const Trajectory& trajectory);

/// The rms of the third time derivative of the position, m/s3, by divided differences over four frames.
double rmsJerk(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
