// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/passivity.h"

#include <algorithm>

namespace hapticell::haptic {

namespace {

constexpr double kMillisecond = 0.001;
constexpr double kAllowance = 0.2e-3;     // J made before the controller acts.
constexpr double kControllerStep = 0.1;   // N s/m per millisecond.
constexpr double kControllerLimit = 5.0;  // N s/m.
constexpr double kUnpaidPower = 2.5e-4;     // W that the spring may gain without the hand's work,
constexpr double kUnpaidBudget = 1.5e-4;    // J at once.

}  // namespace

void PassivityController::reset() {
  account_ = EnergyAccount(delay_);
  damping_ = 0.0;
}

void PassivityController::add(const MetricVector& step, const MetricVector& commanded, double stiffness) {
  account_.add(step, commanded, stiffness);
  account_.forgetGains();
}

void PassivityController::step(bool contact, double dt) {
  const double change = kControllerStep * dt / kMillisecond;
  const bool act = contact && balance() < -kAllowance;
  damping_ = std::clamp(damping_ + (act ? change : -change), 0.0, kControllerLimit);
}

void SpringRation::reset() {
  budget_ = kUnpaidBudget;
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
  if (unpaid <= budget_) {
    budget_ -= std::max(0.0, unpaid);
    return stretch;
  }
  const double allowed = springThatStores(paid + budget_, stiffness, last.limit);
  budget_ = 0.0;
  return std::min(1.0, allowed / pull) * stretch;
}

}  // namespace hapticell::haptic
