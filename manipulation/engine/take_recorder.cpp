// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/take_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "manipulation/manipulators/arm_configuration.h"

namespace hapticell::manipulation {

namespace {

using trajectory::Trajectory;

/// s: a shorter interruption does not end a touch, kInterruption of the session's report. Half: chattering contacts are
/// two; twice: taps of over 10 Hz are one.
constexpr double kTouchGap = 0.05;

/// The same frames, `shift` seconds earlier.
Trajectory shifted(const Trajectory& given, double shift) {
  Trajectory result = given.emptyRecording();
  result.touches = given.touches;
  result.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    Trajectory::Frame frame = given[i];
    frame.t -= shift;
    result.addFrame(frame, given.joints(i), given.channels(i));
  }
  for (Trajectory::Touch& touch : result.touches) {
    touch.t_in -= shift;
    touch.t_out -= shift;
  }
  return result;
}

}  // namespace

Trajectory emptyRecording(const workcell::Entity& entity, const MovedBy& moved_by) {
  const bool is_mannequin = entity.kind() == workcell::EntityKind::kMannequin;
  Trajectory recording;
  recording.name = entity.name;
  recording.entity = entity.name;
  recording.moved = is_mannequin ? "whole" : wordOf(moved_by, entity.robot() != nullptr);
  recording.channel_names = {"force_x", "force_y", "force_z", "contact"};
  if (!entity.robot()) return recording;
  for (const int joint : entity.robot()->moving) {
    recording.joint_names.push_back(entity.robot()->joints[static_cast<std::size_t>(joint)].name);
  }
  return recording;
}

TakeRecorder::TakeRecorder(trajectory::RecordingOptions options, std::string take)
    : options_(options), take_(std::move(take)) {}

TakeRecorder::Track& TakeRecorder::trackOf(const Sample& sample) {
  std::unique_ptr<Track>& track = tracks_[sample.entity->id];
  if (track) return *track;
  Trajectory empty = emptyRecording(*sample.entity, sample.moved_by);
  empty.take = take_;
  auto arm = sixAxisChain(*sample.entity);
  if (arm) empty.channel_names.push_back("configuration");
  trajectory::RecordingOptions options = options_;
  options.clock_start = start_;
  track = std::make_unique<Track>(Track{trajectory::Recorder(std::move(empty), options), std::move(arm), {}});
  order_.push_back(sample.entity->id);
  return *track;
}

void TakeRecorder::follow(Track& track, const Sample& sample, double t) {
  for (const auto& [first, second] : sample.touching) {
    const auto same = [&, &a = first, &b = second](const Trajectory::Touch& touch) {
      return touch.first == a && touch.second == b && t - touch.t_out < kTouchGap;
    };
    auto found = std::find_if(track.touches.begin(), track.touches.end(), same);
    if (found == track.touches.end()) found = track.touches.insert(track.touches.end(), {t, t, first, second, 0.0});
    found->t_out = t;
    found->max_force = std::max(found->max_force, glm::length(sample.force_W));
  }
}

void TakeRecorder::take(const Sample& sample, bool marked) {
  if (!start_) start_ = sample.t;
  Track& track = trackOf(sample);
  follow(track, sample, sample.t - *start_);
  std::array<double, 5> channels{sample.force_W.x, sample.force_W.y, sample.force_W.z,
                                 sample.touching.empty() ? 0.0 : 1.0, 0.0};
  if (track.arm) channels[4] = configurationNumber(*track.arm, sample.at->joints).value_or(0);
  const std::span<const double> told(channels.data(), track.arm ? 5 : 4);
  const bool has_joints = sample.entity->robot() != nullptr;
  const std::span<const double> joints =
      has_joints ? std::span<const double>(sample.at->joints) : std::span<const double>();
  const bool is_mannequin = sample.entity->kind() == workcell::EntityKind::kMannequin;
  const Pose& X_WM = is_mannequin ? sample.at->X_WE : sample.X_WM;
  if (!marked) return track.recorder.add(sample.t, X_WM, joints, told);
  track.recorder.mark(sample.t, X_WM, joints, told);
  if (marked_ != sample.t) ++marks_;
  marked_ = sample.t;
}

void TakeRecorder::touch(const Sample& sample) {
  const auto track = tracks_.find(sample.entity->id);
  if (start_ && track != tracks_.end()) follow(*track->second, sample, sample.t - *start_);
}

std::size_t TakeRecorder::frames() const {
  std::size_t count = 0;
  for (const auto& [id, track] : tracks_) count += track->recorder.soFar().size();
  return count;
}

std::vector<Trajectory> TakeRecorder::finish() {
  std::vector<Trajectory> all;
  double first = std::numeric_limits<double>::infinity();
  for (const workcell::EntityId id : order_) {
    Track& track = *tracks_.at(id);
    Trajectory recorded = track.recorder.finish();
    if (recorded.empty()) continue;
    recorded.touches = std::move(track.touches);
    first = std::min(first, recorded[0].t);
    all.push_back(std::move(recorded));
  }
  for (Trajectory& one : all) one = shifted(one, first);
  order_.clear();
  tracks_.clear();
  start_.reset();
  marks_ = 0;
  marked_.reset();
  return all;
}

}  // namespace hapticell::manipulation
