// SPDX-License-Identifier: Apache-2.0
#include "trajectory/timing/retimed_part.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hapticell::trajectory {

namespace {

/// Way run from the first frame to each, with joints where there are any: what moves fast gets long.
std::vector<double> waysOf(const Trajectory& trajectory, double metres_per_radian, bool by_joints) {
  std::vector<double> ways{0.0};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    double square = 0.0;
    if (by_joints) {
      const auto a = trajectory.joints(i - 1), b = trajectory.joints(i);
      for (std::size_t j = 0; j < a.size(); ++j) square += (b[j] - a[j]) * (b[j] - a[j]);
    } else {
      const PoseDistance distance = distanceBetween(trajectory[i - 1].X_WT, trajectory[i].X_WT);
      const double turned = metres_per_radian * distance.angle;
      square = distance.position * distance.position + turned * turned;
    }
    ways.push_back(ways.back() + std::max(std::sqrt(square), 1e-12));
  }
  return ways;
}

bool isStopped(const RetimingOptions& options) {
  return options.stop != nullptr && *options.stop;
}

}  // namespace

Trajectory pieceOf(const Trajectory& trajectory, const MotionPiece& piece) {
  Trajectory copy = trajectory.emptyCopy();
  for (std::size_t i = piece.first; i <= piece.last; ++i) copy.addFrame(trajectory[i], trajectory.joints(i));
  return copy;
}

Error retimingStopped() {
  return {.found = "stopped before its end", .fix = "Start it again."};
}

Expected<RetimedPart> RetimedPart::of(const Trajectory& motion, const MotionPiece& piece,
                                      const RetimingOptions& options, LimitedBy by) {
  if (isStopped(options)) return makeError(retimingStopped());
  RetimedPart part;
  part.first = piece.first;
  part.frames = pieceOf(motion, piece);
  part.ways = waysOf(part.frames, options.metres_per_radian, by == LimitedBy::kJoints);
  part.path = pathThrough(part.frames, part.ways, options.tolerance, by);
  auto timing = wayTimingOf(*part.path, options);
  HAPTICELL_TRY(timing);
  part.timing = std::move(*timing);
  return part;
}

void RetimedPart::sample(std::size_t count, double dt, const RetimingOptions& options) {
  samples = frames.emptyCopy();
  given = frames.emptyCopy();
  places.clear();
  const double duration = static_cast<double>(count) * dt;
  const WayTiming slowed = timing.slower(duration / timing.duration);
  std::size_t before = 0;
  for (std::size_t i = 0; i <= count; ++i) {
    if (isStopped(options)) return;
    const double t = static_cast<double>(i) * dt;
    const double u = i == count ? ways.back() : slowed.way(t);
    while (before + 2 < ways.size() && ways[before + 1] < u) ++before;
    const double share = std::clamp((u - ways[before]) / (ways[before + 1] - ways[before]), 0.0, 1.0);
    const double t_given = frames[before].t + share * (frames[before + 1].t - frames[before].t);
    const double dwell = i == count ? frames[frames.size() - 1].dwell : 0.0;
    const bool apart = frames.hasJoints() && frames.has_poses;
    samples.addFrame({t, path->pose(u), false, dwell, nullptr, apart}, path->joints(u));
    given.addFrame({t, frames.poseAt(t_given), false, dwell, nullptr, apart}, frames.jointsAt(t_given));
    places.push_back(u);
  }
  // Rests are met to the last digit.
  for (const std::size_t i : {std::size_t{0}, count}) {
    const std::size_t k = i == 0 ? 0 : frames.size() - 1;
    samples.replaceFrame(i, frames[k].X_WT, frames[k].is_pose_apart, frames.joints(k));
  }
}

std::vector<std::size_t> RetimedPart::missedFrames(const RetimingOptions& options, Deviation& worst) const {
  std::vector<std::size_t> missed;
  const SegmentDistance distance(frames, samples, options.tolerance);
  for (std::size_t k = 1; k + 1 < frames.size() && !isStopped(options); ++k) {
    const auto after = std::upper_bound(places.begin(), places.end(), ways[k]);
    const auto at = static_cast<std::size_t>(after - places.begin());
    Deviation nearest{{1e300, 1e300}, 1e300};
    for (std::size_t i = at > 3 ? at - 3 : 0; i + 1 < samples.size() && i < at + 2; ++i) {
      const Deviation one = distance.of(k, {i, i + 1});
      if (one.shareOf(options.tolerance) < nearest.shareOf(options.tolerance)) nearest = one;
    }
    worst.grow(nearest);
    if (nearest.shareOf(options.tolerance) > 1.0) missed.push_back(first + k);
  }
  return missed;
}

}  // namespace hapticell::trajectory
