// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/simplification.h"

#include <algorithm>
#include <cmath>

#include "trajectory/editing/farthest_split.h"
#include "trajectory/editing/segment_distance.h"

namespace hapticell::trajectory {

namespace {

bool mustStay(const Trajectory::Frame& frame) {
  return frame.isSet();
}

}  // namespace

std::vector<std::size_t> framesToKeep(const Trajectory& trajectory, const PathTolerance& tolerance) {
  std::vector<std::size_t> kept;
  if (trajectory.empty()) return kept;
  std::vector<FrameSpan> open;
  std::size_t first = 0;
  kept.push_back(0);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (!mustStay(trajectory[i]) && i + 1 != trajectory.size()) continue;
    kept.push_back(i);
    open.push_back({first, i});
    first = i;
  }
  const SegmentDistance distance(trajectory, trajectory, tolerance);
  const auto off = [&](std::size_t i, const FrameSpan& span) { return distance.of(i, span).shareOf(tolerance); };
  splitAtFarthestTogether(std::move(open), off, kept);
  return kept;
}

Trajectory simplified(const Trajectory& trajectory, const PathTolerance& tolerance) {
  Trajectory result = trajectory.emptyCopy();
  for (const std::size_t i : framesToKeep(trajectory, tolerance)) result.addFrame(trajectory[i], trajectory.joints(i));
  return result;
}

Trajectory withoutStillFrames(const Trajectory& trajectory, const PathTolerance& still) {
  Trajectory result = trajectory.emptyCopy();
  std::size_t last = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == trajectory.size();
    const bool moves = still.shareOf(distanceBetween(trajectory[i].X_WT, trajectory[last].X_WT)) > 1.0;
    const auto before = trajectory.joints(last);
    const auto now = trajectory.joints(i);
    const bool joints_move = !std::equal(before.begin(), before.end(), now.begin(),
                                         [&](double a, double b) { return std::abs(a - b) <= still.angle; });
    if (!is_end && !moves && !joints_move && !mustStay(trajectory[i])) continue;
    result.addFrame(trajectory[i], now);
    last = i;
  }
  return result;
}

Deviation largestDeviation(const Trajectory& original, const Trajectory& other) {
  Deviation worst;
  if (other.empty()) return worst;
  const SegmentDistance distance(original, other, {});
  std::size_t at = 0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    while (at + 2 < other.size() && other[at + 1].t < original[i].t) ++at;
    worst.grow(distance.of(i, {at, std::min(at + 1, other.size() - 1)}));
  }
  return worst;
}

}  // namespace hapticell::trajectory
