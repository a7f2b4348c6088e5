// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/rendering/energy_account.h"

namespace hapticell::haptic {

/// Low-pass filtered velocities of stylus and proxy (first order), in the metric of the device's frame, m/s.
///
/// Force loop's thread; never allocates, locks or throws.
class FilteredVelocities {
 public:
  void reset() { *this = {}; }
  /// Adds the motion of stylus and proxy in `dt` s. A fast filter turns the encoders' steps into noise, a slow one
  /// makes a stiff coupling unstable; so the filter is faster at a higher `stiffness` (N/m).
  void add(const MetricVector& stylus_step, const MetricVector& proxy_step, double stiffness, double dt);

  const MetricVector& stylus_D() const { return stylus_D_; }
  const MetricVector& proxy_D() const { return proxy_D_; }
  /// The stylus's velocity for the passivity controller, filtered more: that controller damps more, so it needs less
  /// noise.
  const MetricVector& slowStylus_D() const { return slow_stylus_D_; }

 private:
  MetricVector stylus_D_, proxy_D_, slow_stylus_D_;
};

}  // namespace hapticell::haptic
