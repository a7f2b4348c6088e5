// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::haptic {

/// How stiff and how damped the coupling between stylus and proxy is.
struct RendererOptions {
  double stiffness = 1000.0;  ///< K wanted, N/m.
  double damping = 2.0;       ///< B wanted, N s/m.
  double delay = 0.001;       ///< From the measurement to the force that answers it, seconds.
  bool adapt = true;          ///< False: K and B are taken as they are, for finding out where they become unstable.
  double peak_force = 6.4;    ///< Of the device, N; forces are compared at set changes after clamping to it.
  double peak_torque = 0.0;   ///< N m. Above 0 turning is felt too, by K and B times the square of kRotationLever;
                              ///< else the proxy's turn is free and nothing is felt of it.
  double tick = 0.001;        ///< Nominal, s: how many ticks `delay` is.
};

/// The options that are stable with nobody holding the stylus: K <= 0.65 * 2.3 N/mm per millisecond of delay,
/// B >= 4 N s/m from 2 ms of delay on, and B <= 8 N s/m in any case: a filtered velocity times more kicks (the limits
/// of the project's own trial with the simulated device). Values that are not finite or not positive are replaced by
/// the defaults.
RendererOptions limitedByDelay(RendererOptions options);

}  // namespace hapticell::haptic
