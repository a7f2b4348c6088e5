// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

struct SmoothingOptions {
  PathTolerance tolerance{};
};

/// What a hand's tremor is like: motion around 9 Hz that a curve of second degree over a quarter of a second leaves.
struct Tremor {
  double position = 0.0;  ///< rms, m.
  double angle = 0.0;     ///< rms, rad.
};

struct SmoothingReport {
  PoseDistance max_deviation{};  ///< Of any recorded frame.
  double rms_deviation = 0.0;    ///< m
  Tremor tremor{};
  bool tremor_exceeds_tolerance = false;  ///< Then the tolerance cannot be kept without keeping the tremor.
  double rms_jerk_before = 0.0;           ///< m/s3, by third differences of the recording.
  double rms_jerk_after = 0.0;            ///< m/s3, of the spline.
  std::size_t spans = 0;
  std::size_t frames_drawn_back = 0;  ///< That no spline brought within the tolerance: they are at its edge.
};

/// A copy with the same times on a cubic spline through position, orientation and joints, with as few spans as keep
/// every frame within the tolerance and the running mean unbiased (so that tremor goes and the path stays). Frames that
/// no spline brings within it (few of them, sharp corners) are drawn back to its edge. Poses and joints are smoothed
/// each by itself and marked so. A trajectory of fewer than four frames comes back as it is.
struct Smoothed {
  Trajectory trajectory;
  SmoothingReport report;
};
Smoothed smoothed(const Trajectory& trajectory, const SmoothingOptions& options = {});

Tremor estimateTremor(const Trajectory& trajectory);

/// rms of the third time derivative of the position, m/s3, by divided differences over four frames.
double rmsJerk(const Trajectory& trajectory);

}  // namespace hapticell::trajectory
