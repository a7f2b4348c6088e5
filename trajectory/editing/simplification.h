// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "trajectory/editing/segment_distance.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Indices of the frames that are enough to stay within `tolerance` of every frame when motion between them is straight
/// (origin on a line, rotation about a fixed axis, joints in proportion), each frame against the nearest place on its
/// segment. Ends, frames set by hand and frames with a dwell are kept. Douglas & Peucker, Cartographica 10(2), 1973,
/// with the largest share of the tolerance as distance.
std::vector<std::size_t> framesToKeep(const Trajectory& trajectory, const PathTolerance& tolerance);

/// A copy with those frames only.
Trajectory simplified(const Trajectory& trajectory, const PathTolerance& tolerance);

/// A copy without the frames in which nothing moves by more than `still` against the last one kept; the time spent
/// there stays, since the frames after keep theirs. The last frame stays. Re-timing needs this: paths do not stand
/// still.
Trajectory withoutStillFrames(const Trajectory& trajectory, const PathTolerance& still);

/// The largest deviation of `original`'s frames from the motion of `other`, each from the nearest place on the segment
/// that `other` runs through at the frame's time, so that a path that crosses itself or comes by again is not mistaken.
Deviation largestDeviation(const Trajectory& original, const Trajectory& other);

}  // namespace hapticell::trajectory
