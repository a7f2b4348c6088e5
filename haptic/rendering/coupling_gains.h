// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/rendering/proxy_mover.h"
#include "haptic/rendering/renderer_options.h"

namespace hapticell::haptic {

/// Largest damping, N s/m, that an entry or a client can request: twice what a coupling has itself at 2 ms of delay
/// (docs/dev/feel.md, "Delay and stiffness"). Half: none adds any there; twice: a step of the encoders is felt
/// twice as much.
inline constexpr double kDampingLimit = 8.0;

/// Stiffness and damping of the coupling in the current tick. In contact both change slowly.
///
/// Force loop's thread; never allocates, locks or throws.
class CouplingGains {
 public:
  /// Sets the options' values at once.
  void take(const RendererOptions& options);
  /// Sets them; no damping acts until updateDamper().
  void reset(const RendererOptions& options);

  /// Moves towards the values that the active rows request; `contact`: there was one in the last tick.
  void approach(const ProxyStep& solved, const RendererOptions& options, bool contact, double dt);
  /// Updates the share of the damping that acts. If something still presses when a contact ends (the zone's edge, an
  /// offset), the damping must not vanish in one step; nor may it appear in one step when a proxy that caught up
  /// arrives. If a hand strikes, damping acts at once.
  void updateDamper(bool contact, bool catches_up, double dt);

  double stiffness() const { return stiffness_; }        ///< N/m.
  double damping() const { return damper_ * damping_; }  ///< N s/m that act now.

 private:
  double stiffness_ = 1000.0;
  double damping_ = 2.0;
  double damper_ = 0.0;    ///< Share of the damping that acts.
  bool arriving_ = false;  ///< The proxy has caught up from far off: its damping returns gradually.
};

}  // namespace hapticell::haptic
