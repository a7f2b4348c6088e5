// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Takes the step out of the force of pulls (ConstraintKind::kPull) when the set changes: what a new set pulls
/// differently goes into an offset that decays, so a guide that moves or is replaced is never felt as a jump. Where the
/// rest of the force changes fast (a hand that bounces off a stop), a pull gives way a little, so that both together
/// change no faster than a contact may.
///
/// Force loop's thread; does not allocate, lock or throw.
class PullBlend {
 public:
  /// Forgets everything; the next pull comes in from zero.
  void reset() { last_D_ = offset_D_ = yield_D_ = rendered_D_ = dvec3(0.0); }

  /// The force to render, N, for the pull `pull_D` of the set in use in a tick of `dt` seconds. `changed`: this set was
  /// not in use in the tick before, or the stylus has entered or left its zone. `rest_step_D`: by how much the rest of
  /// the force has changed in this tick, N.
  dvec3 tick(const dvec3& pull_D, bool changed, double dt, const dvec3& rest_step_D = dvec3(0.0));

  /// What is left of earlier sets, and of what the pull gave way, N.
  dvec3 offset_D() const { return offset_D_ + yield_D_; }

 private:
  dvec3 last_D_{0.0};
  dvec3 offset_D_{0.0};
  dvec3 yield_D_{0.0};
  dvec3 rendered_D_{0.0};
};

}  // namespace hapticell::haptic
