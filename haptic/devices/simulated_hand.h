// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// Fingers that hold a stylus: a mass on it, and a spring and a damper to where the hand wants to be.
struct HandOptions {
  double mass = 0.1;                  ///< kg, fixed to the stylus while it is held.
  double stiffness = 300.0;           ///< N/m.
  double damping = 5.0;               ///< N s/m: 5 firm, 2 loose.
  double rotational_stiffness = 0.6;  ///< N m/rad.
  double rotational_damping = 0.02;   ///< N m s/rad.
  double inertia = 1.0e-4;            ///< kg m^2, of the stylus with the fingers, about any axis.
  double max_speed = 2.0;   ///< m/s the intended pose moves at most (a mouse that jumps is followed by a hand).
  double max_force = 30.0;  ///< N.

  static HandOptions firm() { return {}; }
  static HandOptions loose() {
    HandOptions options;
    options.damping = 2.0;
    return options;
  }
};

/// The intended pose and velocity at one instant.
struct HandIntent {
  Pose X_DH;
  dvec3 v_DH{0.0};
  dvec3 w_DH{0.0};
};

/// A simulated hand on the stylus of a SimulatedDevice. Who drives it (a path, the mouse over the network, a test) says
/// hold() or release() before a tick; the coupling itself is integrated with the device's motion at 10 kHz.
///
/// Second-order hand with the working values of docs/dev/feel.md. Same thread as the device.
class SimulatedHand {
 public:
  explicit SimulatedHand(const HandOptions& options = {}) : options_(options) {}

  const HandOptions& options() const { return options_; }
  void setOptions(const HandOptions& options) { options_ = options; }

  /// Wants the stylus at X_DH at the end of the next tick, with these buttons pressed. An invalid pose is ignored.
  void hold(const Pose& X_DH, std::uint32_t buttons = 0);

  /// Lets go: the stylus moves under its own weight and friction and the device's force.
  void release();

  bool holding() const { return holding_; }
  std::uint32_t buttons() const { return buttons_; }

  /// For SimulatedDevice: the tick of `dt` seconds begins with the stylus at X_DS; plans the intended motion during it.
  void beginTick(const Pose& X_DS, double dt);
  /// For SimulatedDevice: the intent `s` seconds into the tick.
  HandIntent intentAt(double s) const;

 private:
  HandOptions options_;
  bool holding_ = false;
  bool gripping_ = false;  ///< The hand has been closed during a tick already.
  std::uint32_t buttons_ = 0;
  Pose goal_;
  Pose start_;  ///< Intended pose at the tick's beginning.
  double last_dt_ = 0.0;
  dvec3 velocity_{0.0};
  dvec3 angular_velocity_{0.0};
};

}  // namespace hapticell::haptic
