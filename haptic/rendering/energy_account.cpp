// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/energy_account.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

double storedEnergy(double spring, double stiffness, double limit) {
  const double acting = std::min(spring, limit);
  return acting * (spring - 0.5 * acting) / stiffness;
}

double springThatStores(double energy, double stiffness, double limit) {
  const double free = std::sqrt(2.0 * stiffness * std::max(0.0, energy));
  return free <= limit ? free : stiffness * energy / limit + 0.5 * limit;
}

void EnergyAccount::setDelay(int delay_ticks) {
  delay_ = static_cast<std::size_t>(std::clamp(delay_ticks, 0, static_cast<int>(kLongest) - 1));
}

void EnergyAccount::add(const MetricVector& step, const MetricVector& commanded, double stiffness) {
  commanded_[next_] = commanded;
  acting_ = commanded_[(next_ + kLongest - delay_) % kLongest];
  next_ = (next_ + 1) % kLongest;
  work_ -= dot(acting_, step);
  held_ = dot(acting_, acting_) / (2.0 * std::max(stiffness, 1.0));
}

void EnergyAccount::forgetGains() {
  work_ = std::min(work_, held_);
}

void WorstLoss::add(double t, double balance) {
  while (!highest_.empty() && highest_.front().first < t - window_) highest_.pop_front();
  while (!highest_.empty() && highest_.back().second <= balance) highest_.pop_back();
  highest_.emplace_back(t, balance);
  worst_ = std::min(worst_, balance - highest_.front().second);
}

}  // namespace hapticell::haptic
