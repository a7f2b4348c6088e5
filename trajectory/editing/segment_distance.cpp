// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

double Deviation::shareOf(const PathTolerance& tolerance) const {
  return std::max(tolerance.shareOf(pose), joint / tolerance.joint);
}

void Deviation::grow(const Deviation& other) {
  pose.position = std::max(pose.position, other.pose.position);
  pose.angle = std::max(pose.angle, other.pose.angle);
  joint = std::max(joint, other.joint);
}

SegmentDistance::SegmentDistance(const Trajectory& frames, const Trajectory& segments, const PathTolerance& tolerance)
    : frames_(frames),
      segments_(segments),
      tolerance_(tolerance),
      count_joints_(std::isfinite(tolerance.joint) && frames.joint_names.size() == segments.joint_names.size()) {}

std::span<const double> SegmentDistance::jointsOf(const Trajectory& trajectory, std::size_t i) const {
  return count_joints_ ? trajectory.joints(i) : std::span<const double>();
}

Deviation SegmentDistance::of(std::size_t i, FrameSpan segment) const {
  const Pose &X = frames_[i].X_WT, &X_0 = segments_[segment.first].X_WT, &X_1 = segments_[segment.last].X_WT;
  const bool count_poses = frames_.has_poses && segments_.has_poses;
  double length = 0.0, along = 0.0;
  if (count_poses) {
    const dvec3 way = (X_1.p - X_0.p) / tolerance_.position, moved = (X.p - X_0.p) / tolerance_.position;
    const dvec3 turn = rotationVector(glm::conjugate(X_0.q) * X_1.q) / tolerance_.angle;
    const dvec3 turned = rotationVector(glm::conjugate(X_0.q) * X.q) / tolerance_.angle;
    length = glm::dot(way, way) + glm::dot(turn, turn);
    along = glm::dot(way, moved) + glm::dot(turn, turned);
  }
  const auto q = jointsOf(frames_, i), q_0 = jointsOf(segments_, segment.first),
             q_1 = jointsOf(segments_, segment.last);
  for (std::size_t j = 0; j < q.size(); ++j) {
    const double step = (q_1[j] - q_0[j]) / tolerance_.joint;
    length += step * step;
    along += step * (q[j] - q_0[j]) / tolerance_.joint;
  }
  const double share = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  Deviation deviation;
  if (count_poses) deviation.pose = distanceBetween(X, interpolate(X_0, X_1, share));
  for (std::size_t j = 0; j < q.size(); ++j)
    deviation.joint = std::max(deviation.joint, std::abs(q[j] - q_0[j] - share * (q_1[j] - q_0[j])));
  return deviation;
}

}  // namespace hapticell::trajectory
