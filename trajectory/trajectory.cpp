// SPDX-License-Identifier: Apache-2.0
#include "trajectory/trajectory.h"

#include <algorithm>

#include "geometry/assertion.h"

namespace hapticell::trajectory {

std::span<const double> Trajectory::joints(std::size_t i) const {
  return std::span(joints_).subspan(i * joint_names.size(), joint_names.size());
}

bool Trajectory::addFrame(const Frame& frame, std::span<const double> joints) {
  HAPTICELL_DEMAND(joints.size() == joint_names.size());
  if (!frames_.empty() && !(frame.t > frames_.back().t)) return false;
  frames_.push_back(frame);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  return true;
}

void Trajectory::reserve(std::size_t frames) {
  frames_.reserve(frames);
  joints_.reserve(frames * joint_names.size());
}

Trajectory Trajectory::emptyCopy() const {
  Trajectory copy;
  copy.name = name;
  copy.entity = entity;
  copy.moved = moved;
  copy.joint_names = joint_names;
  return copy;
}

Trajectory::Place Trajectory::placeOf(double t) const {
  const auto after = std::upper_bound(frames_.begin(), frames_.end(), t,
                                      [](double time, const Frame& frame) { return time < frame.t; });
  if (after == frames_.begin()) return {0, 0.0};
  const auto before = static_cast<std::size_t>(after - frames_.begin()) - 1;
  if (after == frames_.end()) return {before, 0.0};
  return {before, (t - frames_[before].t) / (after->t - frames_[before].t)};
}

Pose Trajectory::poseAt(double t) const {
  HAPTICELL_DEMAND(!empty());
  const Place place = placeOf(t);
  if (place.share == 0.0) return frames_[place.before].X_WT;
  return interpolate(frames_[place.before].X_WT, frames_[place.before + 1].X_WT, place.share);
}

std::vector<double> Trajectory::jointsAt(double t) const {
  HAPTICELL_DEMAND(!empty());
  const Place place = placeOf(t);
  const auto before = joints(place.before);
  std::vector<double> q(before.begin(), before.end());
  if (place.share == 0.0) return q;
  const auto after = joints(place.before + 1);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += place.share * (after[i] - before[i]);
  return q;
}

PoseDistance distanceBetween(const Pose& a, const Pose& b) {
  return {glm::length(a.p - b.p), glm::length(rotationVector(glm::conjugate(a.q) * b.q))};
}

double PathTolerance::shareOf(const PoseDistance& distance) const {
  return std::max(distance.position / position, distance.angle / angle);
}

}  // namespace hapticell::trajectory
