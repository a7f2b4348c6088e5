// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "haptic/rendering/energy_account.h"

namespace hapticell::manipulation {

/// What one tick of the force loop tells the meter. Device frame, SI.
struct MeteredTick {
  double t = 0.0;
  dvec3 force_D{0.0};               ///< Commanded, N.
  haptic::MetricVector coupling_D;  ///< What of it (and of the torque) is no load's: what is booked, N.
  haptic::MetricVector step_D;  ///< The stylus's way since the last tick, as measured, as seen from what it touches.
  double stiffness = 1000;      ///< Of the coupling, N/m.
};

/// The greatest force and slew of a session, and its worst energy.
///
/// Energy: the worst fall of haptic::EnergyAccount's balance within a second (docs/dev/feel.md). What a held part's weight
/// and inertia do is no part of it.
class ForceExtremes {
 public:
  /// `delay_ticks` of the device, where it is known.
  explicit ForceExtremes(int delay_ticks = 0) : energy_(delay_ticks) {}
  void add(const MeteredTick& tick);
  double maxForce() const { return max_force_; }
  double maxStep() const { return max_step_; }            ///< N per ms.
  double leastEnergy() const { return energy_.worst(); }  ///< J, 0 or negative.

 private:
  bool started_ = false;
  MeteredTick last_;
  double max_force_ = 0.0, max_step_ = 0.0;
  haptic::EnergyLossMeter energy_;
};

}  // namespace hapticell::manipulation
