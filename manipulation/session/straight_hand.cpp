// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/straight_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::manipulation {

namespace {

/// s: the button, then the motion.
constexpr double kPress = 0.05, kLetGo = 0.15, kMoves = 0.3;
/// Hz: physiological tremor is 8 to 12. Half and twice: slower and faster trembling.
constexpr double kTremorRate = 9.0;

}  // namespace

StraightHandOptions seededHand(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1.0p-53;
  };
  StraightHandOptions options;
  options.push = between(0.7, 1.3);
  options.speed = between(0.06, 0.12);
  options.tremor = between(0.1e-3, 0.3e-3);
  options.seed = seed;
  return options;
}

StraightHand::StraightHand(const StraightHandOptions& options) : options_(options) {
  std::mt19937_64 random(options.seed);
  for (int i = 0; i < 3; ++i) {
    phase_[i] = 2.0 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1.0p-53;
  }
}

haptic::HandSample StraightHand::next(double t, const Pose& X_DS, const Pose& X_WM) {
  const double dt = started_ ? std::clamp(t - last_t_, 0.0, 0.1) : 0.0;
  if (!started_) X_DH_ = X_DS;
  last_t_ = t;
  const Twist left = difference(options_.X_WG, X_WM);
  const double way = glm::length(left.linear) / options_.scale;
  const std::uint32_t button = t >= kPress && t < kLetGo ? 1U : 0U;
  if (!started_ || t < kMoves) {
    started_ = true;
    last_left_ = way;
    return {t, X_DH_, button};
  }
  const dvec3 wish = shortenedTo(left.linear / options_.scale, options_.speed * dt);
  // Never farther from the stylus than what it is willing to push: so it gives way.
  X_DH_.p = X_DS.p + shortenedTo(X_DH_.p + wish - X_DS.p, options_.push / options_.stiffness);
  const double nearer = std::clamp((last_left_ - way) / std::max(last_left_, 1e-6), 0.0, 1.0);
  last_left_ = way;
  // Where it has arrived, the rest of the turn.
  const double share = way < 1e-3 ? std::min(1.0, dt) : nearer;
  X_DH_.q = glm::normalize(quaternionFromRotationVector(share * left.angular) * X_DH_.q);
  Pose trembling = X_DH_;
  for (int i = 0; i < 3; ++i) {
    trembling.p[i] += options_.tremor * std::sin(2.0 * std::numbers::pi * kTremorRate * (1.0 + 0.07 * i) * t + phase_[i]);
  }
  return {t, trembling, button};
}

}  // namespace hapticell::manipulation
