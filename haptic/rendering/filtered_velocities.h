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
  /// What stylus and proxy have gone in `dt` s. Damping makes noise of the encoders' steps, a late velocity makes a
  /// stiff coupling unstable: the stiffer (`stiffness`, N/m), the quicker the filter.
  void add(const MetricVector& stylus_step, const MetricVector& proxy_step, double stiffness, double dt);

  const MetricVector& stylus_D() const { return stylus_D_; }
  const MetricVector& proxy_D() const { return proxy_D_; }
  /// The stylus's for the passivity controller, more filtered: it damps more, so its noise must be less.
  const MetricVector& slowStylus_D() const { return slow_stylus_D_; }

 private:
  MetricVector stylus_D_, proxy_D_, slow_stylus_D_;
};

}  // namespace hapticell::haptic
