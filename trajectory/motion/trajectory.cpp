// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/trajectory.h"

#include <algorithm>
#include <array>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

std::span<const double> Trajectory::joints(std::size_t i) const {
  return std::span(joints_).subspan(i * joint_names.size(), joint_names.size());
}

std::span<const double> Trajectory::channels(std::size_t i) const {
  return std::span(channels_).subspan(i * channel_names.size(), channel_names.size());
}

std::optional<std::size_t> Trajectory::findChannel(std::string_view channel) const {
  const auto found = std::find(channel_names.begin(), channel_names.end(), channel);
  if (found == channel_names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channel_names.begin());
}

bool isChannel(std::string_view name) {
  constexpr std::array<std::string_view, 5> kNames{"force_x", "force_y", "force_z", "contact", "configuration"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool Trajectory::addFrame(const Frame& frame, std::span<const double> joints, std::span<const double> channels) {
  HAPTICELL_DEMAND(joints.size() == joint_names.size());
  HAPTICELL_DEMAND(channels.empty() || channels.size() == channel_names.size());
  if (!frames_.empty() && !(frame.t > frames_.back().t)) return false;
  frames_.push_back(frame);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  channels_.insert(channels_.end(), channels.begin(), channels.end());
  channels_.resize(frames_.size() * channel_names.size());
  return true;
}

bool Trajectory::isTaught() const {
  return !empty() && std::all_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.by_hand; });
}

void Trajectory::replaceFrame(std::size_t i, const Pose& X_WT, bool is_pose_apart, std::span<const double> joints) {
  HAPTICELL_DEMAND(i < size() && joints.size() == joint_names.size());
  frames_[i].X_WT = X_WT;
  frames_[i].is_pose_apart = is_pose_apart;
  std::copy(joints.begin(), joints.end(), joints_.begin() + static_cast<std::ptrdiff_t>(i * joint_names.size()));
}

void Trajectory::reserve(std::size_t frames) {
  frames_.reserve(frames);
  joints_.reserve(frames * joint_names.size());
  channels_.reserve(frames * channel_names.size());
}

Trajectory Trajectory::emptyCopy() const {
  Trajectory copy;
  copy.name = name;
  copy.entity = entity;
  copy.moved = moved;
  copy.take = take;
  copy.joint_names = joint_names;
  copy.has_poses = has_poses;
  return copy;
}

Trajectory Trajectory::emptyRecording() const {
  Trajectory copy = emptyCopy();
  copy.channel_names = channel_names;
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
