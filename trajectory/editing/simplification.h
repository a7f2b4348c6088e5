// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "trajectory/editing/segment_distance.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Indices of the frames that suffice to stay within `tolerance` of every frame, if the motion between them is straight
/// (origin on a line, rotation about a fixed axis, joints in proportion). Each frame is compared with the nearest place
/// on its segment. The ends, frames set by hand and frames with a dwell are kept. Douglas & Peucker, Cartographica
/// 10(2), 1973, with the largest share of the tolerance as distance.
std::vector<std::size_t> framesToKeep(const Trajectory& trajectory, const PathTolerance& tolerance);

/// A copy with only those frames.
Trajectory simplified(const Trajectory& trajectory, const PathTolerance& tolerance);

/// A copy without the frames in which nothing moves by more than `still` since the last kept frame. Pauses keep their
/// duration, because later frames keep their times. The last frame is kept. Re-timing needs this: along a path,
/// progress must not stop.
Trajectory withoutStillFrames(const Trajectory& trajectory, const PathTolerance& still);

/// The largest deviation of the frames of `original` from the motion of `other`. Each frame is compared with the
/// nearest place on the segment that `other` passes at the frame's time, so that a path that crosses itself or returns
/// is compared correctly.
Deviation largestDeviation(const Trajectory& original, const Trajectory& other);

}  // namespace hapticell::trajectory
