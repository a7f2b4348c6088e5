// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/passivity.h"

#include <algorithm>

namespace hapticell::haptic {

namespace {

constexpr double kTick = 0.001;  // s.
/// J made before the controller acts (docs/dev/feel.md, 8). Half passes the tests of this folder, twice fails
/// ForceRendererEnergy.DampsWhatAnOverCurvedSetMakes.
constexpr double kAllowance = 0.2e-3;
constexpr double kControllerStep = 0.1;  // N s/m per millisecond. Half and twice pass the tests of this folder.
/// N s/m. Half passes; twice fails ForceRendererEnergy.DampsWhatAnOverCurvedSetMakes.
constexpr double kControllerLimit = 5.0;
constexpr double kSlice = 0.05;  // s of the ring of highest balances: kSlices of them are the second that counts.
/// W that the spring may gain without the hand's work (docs/dev/feel.md, 7), and J at once. Half of either fails
/// ForceRendererEnergy.IsTrueAgainAfterTheHandLiftedByWhatWasHeldBack, twice .ATurnOfTheWristPaysForNothing.
constexpr double kUnpaidPower = 2.5e-4, kUnpaidBudget = 1.5e-4;
constexpr double kGrantLasts = 0.15;  // s. Half and twice pass the tests of this folder.

}  // namespace

void PassivityController::reset() {
  account_ = EnergyAccount(delay_);
  damping_ = prepaid_ = 0.0;
  highest_.fill(0.0);
  slice_ = 0;
  slice_age_ = 0.0;
}

void PassivityController::add(const MetricVector& step, const MetricVector& commanded, double stiffness) {
  const double before = account_.balance();
  account_.add(step, commanded, stiffness);
  const double paid = std::clamp(before - account_.balance(), 0.0, prepaid_);
  account_.credit(paid);
  prepaid_ -= paid;
  account_.forgetGains();
}

void PassivityController::noteHighest(double dt) {
  slice_age_ += dt;
  if (slice_age_ >= kSlice) {
    slice_ = (slice_ + 1) % kSlices;
    slice_age_ = 0.0;
    highest_[slice_] = balance();
  }
  highest_[slice_] = std::max(highest_[slice_], balance());
}

double PassivityController::recentLoss() const {
  return std::max(0.0, *std::max_element(highest_.begin(), highest_.end()) - balance());
}

void PassivityController::step(bool contact, double dt) {
  if (!contact) prepaid_ = 0.0;
  noteHighest(dt);
  const double change = kControllerStep * dt / kTick;
  const bool act = contact && balance() < -kAllowance;
  damping_ = std::clamp(damping_ + (act ? change : -change), 0.0, kControllerLimit);
}

void SpringRation::reset() {
  budget_ = kUnpaidBudget;
  grant_ = grant_lasts_ = lost_ = 0.0;
}

void SpringRation::grant(double energy) {
  grant_ += energy;
  grant_lasts_ = kGrantLasts;
}

MetricVector SpringRation::apply(const MetricVector& stretch, double stiffness, const HeldSpring& last,
                                 const MetricVector& step, double dt) {
  budget_ = std::min(budget_ + kUnpaidPower * dt, kUnpaidBudget);
  const double pull = stiffness * length(stretch);
  const double held = storedEnergy(length(last.spring), last.stiffness, last.limit);
  // What the damper gives where the proxy outruns the stylus is the controller's business.
  const double damped = -dot(last.wanted - last.spring, step);
  const double paid = held - dot(last.applied, step) - std::min(0.0, damped);
  const double unpaid = storedEnergy(pull, stiffness, last.limit) - paid;
  lost_ = std::max(0.0, -unpaid);
  budget_ = std::min(budget_, room_);
  grant_lasts_ = std::max(0.0, grant_lasts_ - dt);
  if (grant_lasts_ <= 0.0) grant_ = 0.0;
  if (unpaid <= budget_ + grant_) {
    const double granted = std::clamp(unpaid, 0.0, grant_);
    grant_ -= granted;
    budget_ -= std::max(0.0, unpaid - granted);
    return stretch;
  }
  const double allowed = springThatStores(paid + budget_ + grant_, stiffness, last.limit);
  budget_ = grant_ = 0.0;
  return std::min(1.0, allowed / pull) * stretch;
}

}  // namespace hapticell::haptic
