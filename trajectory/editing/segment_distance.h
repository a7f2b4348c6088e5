// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// The deviation of one motion from another.
struct Deviation {
  PoseDistance pose;
  double joint = 0.0;  ///< rad (m), of the joint with the largest deviation.
  /// The largest deviation as a share of its tolerance; above 1 is out of tolerance.
  double shareOf(const PathTolerance& tolerance) const;
  /// The larger value of each field.
  void grow(const Deviation& other);
};

/// Two frames between which a motion is straight.
struct FrameSpan {
  std::size_t first, last;
};

/// Compares frames of one motion with straight segments of another: pose and joints at the same place on the segment.
class SegmentDistance {
 public:
  /// Both must outlive it. Joints are compared if both have the same number and the joint tolerance is finite, poses if
  /// both have them.
  SegmentDistance(const Trajectory& frames, const Trajectory& segments, const PathTolerance& tolerance);

  /// The deviation of frame `i` from the nearest place on the segment, weighted by the tolerance.
  Deviation of(std::size_t i, FrameSpan segment) const;

 private:
  std::span<const double> jointsOf(const Trajectory& trajectory, std::size_t i) const;

  const Trajectory& frames_;
  const Trajectory& segments_;
  const PathTolerance tolerance_;
  bool count_joints_;
};

}  // namespace hapticell::trajectory
