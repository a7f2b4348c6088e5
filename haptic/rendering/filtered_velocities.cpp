// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/filtered_velocities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::haptic {

namespace {

// Half and twice of each pass the tests of this folder.
constexpr double kQuietFilter = 75.0, kQuickFilter = 100.0;  // Hz, at kSoft and below, and for stiff couplings.
constexpr double kControllerFilter =
    40.0;                         // Hz: at 5 N s/m a step of the encoders would else be 0.04 N (docs/dev/feel.md, 8).
constexpr double kSoft = 1000.0;  // N/m.

double filterFrequency(double stiffness) {
  return std::clamp(kQuietFilter * stiffness / kSoft, kQuietFilter, kQuickFilter);
}

double lowPassGain(double frequency, double dt) {
  return 1.0 - std::exp(-2.0 * std::numbers::pi * frequency * dt);
}

}  // namespace

void FilteredVelocities::add(const MetricVector& stylus_step, const MetricVector& proxy_step, double stiffness,
                             double dt) {
  const double gain = lowPassGain(filterFrequency(stiffness), dt);
  stylus_D_ += gain * ((1.0 / dt) * stylus_step - stylus_D_);
  proxy_D_ += gain * ((1.0 / dt) * proxy_step - proxy_D_);
  slow_stylus_D_ += lowPassGain(kControllerFilter, dt) * ((1.0 / dt) * stylus_step - slow_stylus_D_);
}

}  // namespace hapticell::haptic
