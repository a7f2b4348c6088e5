// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// The load on the hand apart from contacts: the force class *dynamics*, and the felt share of a part's weight.
struct LoadOptions {
  double mass = 0.0;      ///< kg whose inertia is felt, 0 .. 2.
  double damping = 0.0;   ///< N s/m against its motion, 0 .. 20.
  double friction = 0.0;  ///< N, dry friction: the force to start moving a hinge or a slide, 0 .. 3.
  dvec3 weight_D{0.0};    ///< N on the hand, the weight that remains after gravity compensation, at most 5.

  bool operator==(const LoadOptions&) const = default;
};

/// The options, limited to their ranges; values that are not finite become 0.
LoadOptions sane(LoadOptions options);

/// A mass on a spring and a damper at the stylus (a virtual tool behind a virtual coupling, E. Colgate): its inertia,
/// damping and weight are felt without measuring an acceleration. When a contact stops the stylus the mass moves on, so
/// a heavy part strikes harder than a light one. A weight changes at 5 N/s, never in a step.
///
/// Force loop's thread; never allocates, locks or throws. Without a load the force is exactly zero.
class HeldLoad {
 public:
  /// A new mass starts at rest relative to the stylus.
  void setOptions(const LoadOptions& options);
  const LoadOptions& options() const { return options_; }
  void reset();

  /// `p_DS` and filtered velocity `v_DS` of the stylus; returns the force on the hand, N.
  dvec3 tick(const dvec3& p_DS, const dvec3& v_DS, double dt);

 private:
  dvec3 drag(const dvec3& p_DS);
  void moveMass(const dvec3& p_DS, const dvec3& v_DS, double dt);

  LoadOptions options_;
  bool has_mass_ = false;
  dvec3 p_DM_{0.0}, v_DM_{0.0};
  dvec3 weight_D_{0.0};  ///< Felt now, N.
  bool rubs_ = false;
  dvec3 p_DA_{0.0};  ///< Anchor of the friction's spring.
};

}  // namespace hapticell::haptic
