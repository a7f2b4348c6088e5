// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/coupling_spring.h"

#include <algorithm>
#include <limits>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

/// m, and in so many s: 0.05 N a millisecond at 1 N/mm (docs/dev/feel.md, 6). Twice as fast fails
/// ForceRenderer.MeetsTheEdgeOfAZoneWithoutAStep, half as fast .DropsAForceThatANewSetTakesAwaySlowlyThenExactly.
constexpr double kOffsetDecay = 0.05e-3, kOffsetDecayTime = 0.001;
// Of the next three half and twice pass the tests of this folder and of tests/feel.
constexpr double kFadeTime = 0.005;   // s, of a small offset in contact (docs/dev/feel.md, 6).
constexpr double kOffsetGone = 1e-6;  // m.
constexpr double kPull = 1e-3;        // N.
// A yielded spring comes back under a hand that rests (docs/dev/feel.md, 7). Of all but the last half and twice pass
// the tests of this folder and YieldedSpring's.
constexpr double kAtRest = 0.3e-3;       // m that a hand at rest stays within,
constexpr double kRested = 0.2;          // and for so many s.
constexpr double kRestDrifts = 5e-3;     // m/s: a hand that gives way to what comes back rests, too.
constexpr double kCreepPower = 0.25e-3;  // W, what the ration gives.
/// s for all that the motors bear, where the hand has paid. Half and twice fail
/// YieldedSpring.ComesBackWithinTwoSecondsUnderAHandThatRests.
constexpr double kComesBack = 1.5;

}  // namespace

bool RestWatch::rests(const ProxyMover& mover, const Pose& X_DS, double dt) {
  const MetricVector away = mover.way(X_DS, place_);
  if (length(away) < kAtRest) {
    since_ += dt;
    place_ = displacedInMetric(place_, asVector6(limited(away, kRestDrifts * dt)));
  } else {
    since_ = 0.0;
    place_ = X_DS;
  }
  return since_ >= kRested;
}

void CouplingSpring::reset() {
  offset_D_ = stretch_D_ = {};
  yield_ = last_yield_ = yielded_ = 0.0;
  last_ = {};
  last_.stiffness = stiffness_;
  last_.limit = std::numeric_limits<double>::infinity();
  ration_.reset();
}

/// What is left of a stretch to a spring that yields at the force limit. It shortens the stretch but never turns it, so
/// that what holds the proxy decides the direction of the force.
MetricVector CouplingSpring::borne(const MetricVector& stretch_D) {
  const double size = length(stretch_D);
  if (size <= 0.0) {
    yield_ = 0.0;
    return stretch_D;
  }
  yield_ = std::clamp(yield_, std::max(0.0, size - motors_.along(stretch_D) / stiffness_), size);
  return (1.0 - yield_ / size) * stretch_D;
}

void CouplingSpring::changeStretch(const MetricVector& before_D, const MetricVector& after_D) {
  const MetricVector borne_before = borne(before_D);
  offset_D_ += borne_before - borne(after_D);
}

void CouplingSpring::restartStretch(const MetricVector& stretch_D, bool contact) {
  stretch_D_ = stretch_D;
  yield_ = 0.0;
  const MetricVector new_D = borne(stretch_D);
  offset_D_ = contact ? (1.0 / stiffness_) * last_.spring - new_D : MetricVector{};
  ration_.grant(0.5 * stiffness_ * dot(new_D, new_D));
}

MetricVector CouplingSpring::stretchTo(const MetricVector& stretch_D, const MetricVector& by_set_D,
                                       const MetricVector& stylus_step) {
  const MetricVector growth = stretch_D - stretch_D_ - by_set_D + stylus_step;
  stretch_D_ = stretch_D;
  return growth;
}

void CouplingSpring::absorb(const MetricVector& excess_D) {
  if (excess_D == MetricVector{}) return;
  changeStretch(stretch_D_ - excess_D, stretch_D_);
}

void CouplingSpring::decayOffset(bool contact, const MetricVector& stylus_step, double dt) {
  const double size = length(offset_D_);
  if (size <= kOffsetGone) {
    offset_D_ = {};
    return;
  }
  double decay = kOffsetDecay * dt / kOffsetDecayTime;
  if (contact) {
    decay = std::min(decay, size * dt / kFadeTime);
  } else {
    decay += std::max(0.0, dot(stylus_step, offset_D_)) / size;  // It is no push to be had for nothing.
  }
  offset_D_ *= 1.0 - std::min(1.0, decay / size);
}

double CouplingSpring::creepBack(bool rests, bool contact, double dt) {
  last_yield_ = yield_;
  const double size = length(stretch_D_);
  if (yield_ <= 0.0 || !contact || size <= 0.0) {
    yielded_ = 0.0;
    return 0.0;
  }
  if (!rests) return 0.0;
  const double limit = motors_.along(stretch_D_);
  const double least = std::max(0.0, size - limit / stiffness_);
  const double pull = std::max(stiffness_ * (size - yield_), kPull);
  const double rationed = std::min(kOffsetDecay * dt / kOffsetDecayTime, kCreepPower * dt / pull);
  const double paid = std::min(limit / stiffness_ * dt / kComesBack, yielded_ / pull);
  const double back = std::clamp(yield_ - least, 0.0, std::max(rationed, paid));
  const double energy = std::min(yielded_, (pull + 0.5 * stiffness_ * back) * back);
  yielded_ -= energy;
  ration_.grant(energy);
  yield_ -= back;
  offset_D_ -= (back / size) * stretch_D_;
  return energy;
}

/// A hand that lifts faster than the offset fades must not be pulled back by it: a spring that pushed ends at nothing.
MetricVector CouplingSpring::pushing(const MetricVector& spring_D, const MetricVector& left_D) const {
  const double along = dot(spring_D, left_D);
  const bool pulled = dot(last_.spring, left_D) < -kPull * length(left_D);
  if (along >= 0.0 || pulled) return spring_D;
  return spring_D - (along / dot(left_D, left_D)) * left_D;
}

void CouplingSpring::update(bool holds, double room, const MetricVector& relative_step, double dt) {
  ration_.limit(room);
  const bool free = !holds && offset_D_ == MetricVector{};
  const MetricVector left_D = borne(free ? MetricVector{} : stretch_D_);
  const MetricVector pushing_D = pushing(left_D + offset_D_, left_D);
  const MetricVector wanted_D = limited(pushing_D, motors_.along(pushing_D) / stiffness_);
  const MetricVector spring_D = ration_.apply(wanted_D, stiffness_, last_, relative_step, dt);
  offset_D_ = spring_D - left_D;
  last_.spring = stiffness_ * spring_D;
  last_.stiffness = stiffness_;
  const double yields = yield_ - last_yield_;
  if (yields > 0.0) yielded_ += std::min(ration_.lost(), length(last_.spring) * yields);
}

MetricVector CouplingSpring::withoutPull(const MetricVector& damper_D) const {
  const double stretch2 = dot(stretch_D_, stretch_D_);
  if (stretch2 <= 0.0) return damper_D;
  const double spring = dot(last_.spring, stretch_D_), pulled = dot(damper_D, stretch_D_) + std::max(0.0, spring);
  return pulled < 0.0 ? damper_D - (pulled / stretch2) * stretch_D_ : damper_D;
}

void CouplingSpring::noteWanted(const MetricVector& force_D) {
  last_.applied = last_.wanted = force_D;
  last_.limit = std::numeric_limits<double>::infinity();
}

void CouplingSpring::noteApplied(const MetricVector& force_D) {
  last_.applied = force_D;
  const double applied = length(force_D);
  if (applied < 0.999 * length(last_.wanted)) last_.limit = applied;
}

}  // namespace hapticell::haptic
