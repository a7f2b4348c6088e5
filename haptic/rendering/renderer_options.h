// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::haptic {

/// Stiffness, damping and limits of the coupling between stylus and proxy.
struct RendererOptions {
  double stiffness = 1000.0;  ///< K wanted, N/m.
  double damping = 2.0;       ///< B wanted, N s/m.
  double delay = 0.001;       ///< From the measurement to the resulting force, seconds.
  bool adapt = true;          ///< False: K and B are used unchanged, to find out where they become unstable.
  double peak_force = 6.4;    ///< Of the device, N; at set changes, forces are compared after clamping to it.
  double peak_torque = 0.0;   ///< N m. If above 0, rotation is felt too, with K and B times the square of
                              ///< kRotationLever; else the proxy's rotation is free and not felt.
  double tick = 0.001;        ///< Nominal tick, s; converts `delay` to ticks.
};

/// The options, limited to values that are stable when nobody holds the stylus: K <= 0.65 * 2.3 N/mm per millisecond of
/// delay, B >= 4 N s/m from 2 ms of delay on, and B <= 8 N s/m in any case: with more damping, a filtered velocity
/// makes the force jump (limits found in our trials with the simulated device). Values that are not finite or not
/// positive are replaced by the defaults.
RendererOptions limitedByDelay(RendererOptions options);

}  // namespace hapticell::haptic
