// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// What the hand carries besides touching: the force class *dynamics*, and what of a part's weight is to be felt.
struct LoadOptions {
  double mass = 0.0;      ///< kg whose inertia is felt, 0 .. 2; 0: none.
  double damping = 0.0;   ///< N s/m against its motion, 0 .. 20.
  double friction = 0.0;  ///< N, dry: what a hinge or a slide needs to be moved at all, 0 .. 3.
  dvec3 weight_D{0.0};    ///< N on the hand; what gravity compensation leaves of the weight, at most 5.

  bool operator==(const LoadOptions&) const = default;
};

/// The options within their ranges; what is not finite becomes 0.
LoadOptions sane(LoadOptions options);

/// A mass on a spring and a damper at the stylus (a virtual tool behind a virtual coupling, E. Colgate): its inertia,
/// its damping and its weight are felt without ever measuring an acceleration. When a contact stops the stylus the mass
/// runs on, so that a heavy part strikes harder than a light one. A weight comes and goes at 5 N/s, never as a step.
///
/// Force loop's thread; never allocates, locks or throws. Without a load the force is exactly zero.
class HeldLoad {
 public:
  /// A mass that appears is at rest with the stylus.
  void setOptions(const LoadOptions& options);
  const LoadOptions& options() const { return options_; }
  void reset();

  /// `p_DS` and filtered velocity `v_DS` of the stylus; the force on the hand, N.
  dvec3 tick(const dvec3& p_DS, const dvec3& v_DS, double dt);

 private:
  dvec3 drag(const dvec3& p_DS);
  void moveMass(const dvec3& p_DS, const dvec3& v_DS, double dt);

  LoadOptions options_;
  bool has_mass_ = false;
  dvec3 p_DM_{0.0}, v_DM_{0.0};
  dvec3 weight_D_{0.0};  ///< Felt now, N.
  bool rubs_ = false;
  dvec3 p_DA_{0.0};  ///< Where the friction's spring is tied to.
};

}  // namespace hapticell::haptic
