// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/rendering/proxy_mover.h"
#include "haptic/rendering/renderer_options.h"

namespace hapticell::haptic {

/// N s/m that an entry or a client can ask for at most.
inline constexpr double kDampingLimit = 8.0;

/// Stiffness and damping of the coupling as they act in a tick. In contact both change slowly.
///
/// Force loop's thread; never allocates, locks or throws.
class CouplingGains {
 public:
  /// Takes the options' values at once.
  void take(const RendererOptions& options);
  /// Takes them, and no damping acts until updateDamper().
  void reset(const RendererOptions& options);

  /// Goes towards what the active rows ask for; `contact`: there was one in the last tick.
  void approach(const ProxyStep& solved, const RendererOptions& options, bool contact, double dt);
  /// What still presses when a contact ends (the zone's edge, an offset) must not lose its damping in one step, nor get
  /// it in one when a proxy that caught up has arrived. A hand that strikes is damped at once.
  void updateDamper(bool contact, bool catches_up, double dt);

  double stiffness() const { return stiffness_; }        ///< N/m.
  double damping() const { return damper_ * damping_; }  ///< N s/m that act.

 private:
  double stiffness_ = 1000.0;
  double damping_ = 2.0;
  double damper_ = 0.0;    ///< Share of the damping that acts.
  bool arriving_ = false;  ///< The proxy has caught up from far off: its damping returns gradually.
};

}  // namespace hapticell::haptic
