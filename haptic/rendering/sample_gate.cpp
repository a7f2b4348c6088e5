// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/sample_gate.h"

#include <algorithm>
#include <cmath>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

constexpr double kMillisecond = 0.001;
// docs/dev/feel.md, "Faults". Half of the first two fails SampleGate.ADeviceThatSaysEachPlaceSeveralTimesFollows, twice
// passes the tests of this folder; of the last two half and twice pass.
constexpr double kOfLate = 0.02;    // s: longer than between two samples of the slowest devices.
constexpr double kQuicker = 2.0;    // than of late.
constexpr double kGathering = 4.0;  // A way that grows from rest, tick by tick: 1, 4, 9.
constexpr double kBack = 0.05e-3;   // m by the square of a millisecond: 100 m/s2, a hand that is seen again.

double distanceOf(const Pose& a, const Pose& b) {
  return lengthOf(metricDifference(a, b));
}

}  // namespace

SampleGate::Verdict SampleGate::believe(const Pose& X_DS) {
  believed_ = X_DS;
  refusing_ = jumped_ = false;
  elapsed_ = 0.0;
  return Verdict::kFollows;
}

SampleGate::Verdict SampleGate::judge(const Pose& X_DS, double dt) {
  if (!started_) {
    started_ = true;
    speed_ = 0.0;
    return believe(X_DS);
  }
  elapsed_ += dt;
  const double ticks = std::max(1.0, elapsed_ / kMillisecond), last_tick = std::max(1.0, dt / kMillisecond);
  const double way = distanceOf(X_DS, believed_);
  const double first = distanceOf(refused_, believed_), second = distanceOf(X_DS, refused_);
  const bool stays = refusing_ && second <= kLeap * last_tick * last_tick + kQuicker * speed_ * dt;
  // The room that time gives is for samples that were missed: one that is where a jump led has not gone there since.
  const bool goes_on = jumped_ && second < way && second <= kJump * last_tick;
  const double room =
      refusing_ ? std::max(kLeap * last_tick * last_tick, kBack * ticks * ticks) : kLeap * ticks * ticks;
  if (!goes_on && way <= room + kQuicker * speed_ * elapsed_) {
    speed_ = std::max(way / elapsed_, speed_ * std::exp(-elapsed_ / kOfLate));
    return believe(X_DS);
  }
  const bool gathers = refusing_ && first < kJump * last_tick && second <= kGathering * first;
  if (!jumped_ && (stays || gathers) && way <= kJump * ticks) {
    speed_ = way / elapsed_;
    return believe(X_DS);
  }
  jumped_ = jumped_ || way > kJump * ticks;
  refused_ = X_DS;
  refusing_ = true;
  return Verdict::kRefused;
}

}  // namespace hapticell::haptic
