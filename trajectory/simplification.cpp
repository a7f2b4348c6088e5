// SPDX-License-Identifier: Apache-2.0
#include "trajectory/simplification.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

/// The place of the segment nearest to X, weighing position and angle by the tolerance: the projection in position
/// where the segment is long there, else the share of the rotation.
double shareOfSegment(const Pose& X, const Pose& X_0, const Pose& X_1, const PathTolerance& tolerance) {
  const dvec3 way = (X_1.p - X_0.p) / tolerance.position;
  const dvec3 turn = rotationVector(glm::conjugate(X_0.q) * X_1.q) / tolerance.angle;
  const dvec3 moved = (X.p - X_0.p) / tolerance.position;
  const dvec3 turned = rotationVector(glm::conjugate(X_0.q) * X.q) / tolerance.angle;
  const double length = glm::dot(way, way) + glm::dot(turn, turn);
  if (length <= 0.0) return 0.0;
  return std::clamp((glm::dot(way, moved) + glm::dot(turn, turned)) / length, 0.0, 1.0);
}

PoseDistance distanceToSegment(const Pose& X, const Pose& X_0, const Pose& X_1, const PathTolerance& tolerance) {
  return distanceBetween(X, interpolate(X_0, X_1, shareOfSegment(X, X_0, X_1, tolerance)));
}

struct Span {
  std::size_t first, last;
};

bool mustStay(const Trajectory::Frame& frame) {
  return frame.isSet();
}

}  // namespace

std::vector<std::size_t> framesToKeep(const Trajectory& trajectory, const PathTolerance& tolerance) {
  std::vector<std::size_t> kept;
  if (trajectory.empty()) return kept;
  std::vector<Span> open;
  std::size_t first = 0;
  kept.push_back(0);
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (!mustStay(trajectory[i]) && i + 1 != trajectory.size()) continue;
    kept.push_back(i);
    open.push_back({first, i});
    first = i;
  }
  while (!open.empty()) {
    const Span span = open.back();
    open.pop_back();
    double worst = 1.0;
    std::size_t at = 0;
    for (std::size_t i = span.first + 1; i < span.last; ++i) {
      const double share = tolerance.shareOf(
          distanceToSegment(trajectory[i].X_WT, trajectory[span.first].X_WT, trajectory[span.last].X_WT, tolerance));
      if (share <= worst) continue;
      worst = share;
      at = i;
    }
    if (at == 0) continue;
    kept.push_back(at);
    open.push_back({span.first, at});
    open.push_back({at, span.last});
  }
  std::sort(kept.begin(), kept.end());
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

PoseDistance largestDeviation(const Trajectory& original, const Trajectory& other) {
  PoseDistance worst;
  if (other.empty()) return worst;
  const PathTolerance unit;
  std::size_t at = 0;  // the segment where the search goes on: both run forward
  for (const auto& frame : original.frames()) {
    double best = 1e300;
    PoseDistance nearest;
    std::size_t best_at = at;
    const std::size_t end = std::min(other.size(), at + 64);
    for (std::size_t i = at; i < end; ++i) {
      const std::size_t next = std::min(i + 1, other.size() - 1);
      const PoseDistance distance = distanceToSegment(frame.X_WT, other[i].X_WT, other[next].X_WT, unit);
      if (unit.shareOf(distance) >= best) continue;
      best = unit.shareOf(distance);
      nearest = distance;
      best_at = i;
    }
    at = best_at;
    worst.position = std::max(worst.position, nearest.position);
    worst.angle = std::max(worst.angle, nearest.angle);
  }
  return worst;
}

}  // namespace hapticell::trajectory
