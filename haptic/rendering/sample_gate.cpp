// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/sample_gate.h"

#include <algorithm>
#include <cmath>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

constexpr double kMillisecond = 0.001;
constexpr double kOfLate = 0.02;    // s: longer than between two samples of the slowest devices.
constexpr double kQuicker = 2.0;    // than of late.
constexpr double kGathering = 4.0;  // A way that grows from rest, tick by tick: 1, 4, 9.

double distanceOf(const Pose& a, const Pose& b) {
  return lengthOf(metricDifference(a, b));
}

}  // namespace

SampleGate::Verdict SampleGate::believe(const Pose& X_DS, Verdict verdict) {
  believed_ = X_DS;
  refused_count_ = 0;
  elapsed_ = 0.0;
  return verdict;
}

SampleGate::Verdict SampleGate::judge(const Pose& X_DS, double dt) {
  if (!started_) {
    started_ = true;
    speed_ = 0.0;
    return believe(X_DS, Verdict::kFollows);
  }
  elapsed_ += dt;
  const double ticks = std::max(1.0, elapsed_ / kMillisecond), last_tick = std::max(1.0, dt / kMillisecond);
  const double way = distanceOf(X_DS, believed_);
  const double leap = kLeap * ticks * ticks + kQuicker * speed_ * elapsed_;
  if (way <= leap) {
    speed_ = std::max(way / elapsed_, speed_ * std::exp(-elapsed_ / kOfLate));
    return believe(X_DS, Verdict::kFollows);
  }
  const double first = distanceOf(refused_, believed_), second = distanceOf(X_DS, refused_);
  const bool stays = second <= kLeap * last_tick * last_tick + kQuicker * speed_ * dt;
  const bool gathers = first < kJump * last_tick && second <= kGathering * first;
  if (refused_count_ > 0 && (stays || gathers || refused_count_ >= kMostRefused)) {
    const bool jumped = way > kJump * ticks;
    speed_ = jumped ? 0.0 : way / elapsed_;
    return believe(X_DS, jumped ? Verdict::kJumped : Verdict::kFollows);
  }
  refused_ = X_DS;
  ++refused_count_;
  return Verdict::kRefused;
}

}  // namespace hapticell::haptic
