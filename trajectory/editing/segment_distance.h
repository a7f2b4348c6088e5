// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// How far a motion is from another.
struct Deviation {
  PoseDistance pose;
  double joint = 0.0;  ///< rad (m), of the joint that is farthest off.
  /// The largest share; over 1 is out of tolerance.
  double shareOf(const PathTolerance& tolerance) const;
  /// Each by itself the larger one.
  void grow(const Deviation& other);
};

/// Two frames between which a motion goes straight.
struct FrameSpan {
  std::size_t first, last;
};

/// Frames of one motion against straight segments of another: pose and joints at one place of the segment.
class SegmentDistance {
 public:
  /// Both must outlive it. Joints count where both have as many and their tolerance is finite, poses where both have
  /// them.
  SegmentDistance(const Trajectory& frames, const Trajectory& segments, const PathTolerance& tolerance);

  /// Frame `i` from the nearest place of the segment, all weighed by the tolerance.
  Deviation of(std::size_t i, FrameSpan segment) const;

 private:
  std::span<const double> jointsOf(const Trajectory& trajectory, std::size_t i) const;

  const Trajectory& frames_;
  const Trajectory& segments_;
  const PathTolerance tolerance_;
  bool count_joints_;
};

}  // namespace hapticell::trajectory
