// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/recorder.h"

#include <algorithm>
#include <cmath>

namespace hapticell::trajectory {

namespace {

/// What the joints alone do: a figure's arm moves while its root stands, a redundant arm about its still tool.
double largestTurn(std::span<const double> from, std::span<const double> to) {
  double turn = 0.0;
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) turn = std::max(turn, std::abs(to[i] - from[i]));
  return turn;
}

}  // namespace

Recorder::Recorder(Trajectory empty, const RecordingOptions& options)
    : trajectory_(std::move(empty)), options_(options) {}

/// True once the entity has moved from where it stood when recording began; the step before that is the first frame.
bool Recorder::hasStarted(const Step& step) {
  if (started_) return true;
  if (!first_) {
    first_ = step;
    return false;
  }
  if (options_.soft_start.shareOf(distanceBetween(first_->X_WT, step.X_WT)) <= 1.0 &&
      largestTurn(first_->joints, step.joints) <= options_.soft_start.angle)
    return false;
  started_ = true;
  if (options_.mode != RecordingMode::kByHand) keep(last_.value_or(*first_), false);
  return true;
}

bool Recorder::isWanted(const Step& step) const {
  if (trajectory_.empty()) return options_.mode != RecordingMode::kByHand;
  const auto& kept = trajectory_[trajectory_.size() - 1];
  switch (options_.mode) {
    case RecordingMode::kEveryStep:
      return true;
    // Half a microsecond early is on time: steps come at rounded multiples.
    case RecordingMode::kByTime:
      return step.t - t_start_ - kept.t >= options_.interval_s - 5e-7;
    case RecordingMode::kByDistance:
      return options_.spacing.shareOf(distanceBetween(kept.X_WT, step.X_WT)) >= 1.0 ||
             largestTurn(trajectory_.joints(trajectory_.size() - 1), step.joints) >= options_.spacing.angle;
    case RecordingMode::kByHand:
      return false;
  }
  return false;
}

void Recorder::keep(const Step& step, bool by_hand) {
  if (trajectory_.empty()) t_start_ = options_.clock_start.value_or(step.t);
  trajectory_.addFrame({step.t - t_start_, step.X_WT, by_hand, 0.0}, step.joints, step.channels);
}

void Recorder::add(double t, const Pose& X_WT, std::span<const double> joints, std::span<const double> channels) {
  if (last_ && !(t > last_->t)) return;
  Step step{t, X_WT, {joints.begin(), joints.end()}, {channels.begin(), channels.end()}};
  if (hasStarted(step) && isWanted(step)) keep(step, false);
  last_ = std::move(step);
}

void Recorder::mark(double t, const Pose& X_WT, std::span<const double> joints, std::span<const double> channels) {
  if (last_ && !(t > last_->t)) return;
  started_ = true;
  last_ = Step{t, X_WT, {joints.begin(), joints.end()}, {channels.begin(), channels.end()}};
  keep(*last_, true);
}

Trajectory Recorder::finish() {
  if (started_ && last_ && options_.mode != RecordingMode::kByHand) keep(*last_, false);
  Trajectory done = std::move(trajectory_);
  trajectory_ = done.emptyRecording();
  first_.reset();
  last_.reset();
  started_ = false;
  return done;
}

}  // namespace hapticell::trajectory
