// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "haptic/rendering/energy_account.h"

namespace hapticell::manipulation {

/// Data of one tick of the force loop. Device frame, SI.
struct MeteredTick {
  double t = 0.0;
  dvec3 force_D{0.0};               ///< Commanded, N.
  haptic::MetricVector coupling_D;  ///< Without loads, for the energy account, N.
  haptic::MetricVector step_D;      ///< Measured motion of the stylus since the last tick, relative to what it touches.
  double stiffness = 1000;          ///< Of the coupling, N/m.
  dvec3 pull_D{0.0};                ///< Part of the force from pulls and loads, N.
};

/// The greatest force and slew of a session, and its worst energy balance.
///
/// Energy: the worst decrease of the balance of haptic::EnergyAccount within a second (docs/dev/feel.md). Does not
/// include work of a held part's weight and inertia.
class ForceExtremes {
 public:
  /// `delay_ticks` of the device, if known.
  explicit ForceExtremes(int delay_ticks = 0) : energy_(delay_ticks) {}
  void add(const MeteredTick& tick);
  double maxForce() const { return max_force_; }
  double maxStep() const { return max_step_; }            ///< N per ms.
  double maxPullStep() const { return max_pull_step_; }   ///< N per ms, of pulls and loads alone.
  double leastEnergy() const { return energy_.worst(); }  ///< J, 0 or negative.

 private:
  bool started_ = false;
  MeteredTick last_;
  double max_force_ = 0.0, max_step_ = 0.0, max_pull_step_ = 0.0;
  haptic::EnergyLossMeter energy_;
};

}  // namespace hapticell::manipulation
