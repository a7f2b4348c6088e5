// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/in_memory_link.h"

namespace hapticell::haptic {

/// A horizontal floor at `height` (D, metres), as a set that is complete around `p_DR`.
inline ConstraintSet floorSet(std::uint64_t sequence, double height = 0.0, const dvec3& p_DR = dvec3(0.0)) {
  ConstraintSet set;
  set.sequence = sequence;
  set.X_DR = Pose::translation(p_DR);
  set.count = 1;
  set.constraints[0].gap = p_DR.z - height;
  set.constraints[0].gradient = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  set.constraints[0].id = 1;
  return set;
}

/// The loop's own options but for one: the tests' clients say a set once and hold on to it, so by default their loop is
/// not taken for one that hangs.
inline ForceLoopOptions patientOptionsFor(const Device& device, double rate_hz = 1000.0,
                                          double set_silence_limit = 1e9) {
  ForceLoopOptions options = optionsFor(device, rate_hz);
  options.safety.set_silence_limit = set_silence_limit;
  return options;
}

/// Simulated device, hand, force loop and link in virtual time; a client in the test's hands.
struct VirtualSession {
  explicit VirtualSession(const InMemoryLinkOptions& network = {}, double rate_hz = 1000.0,
                          double set_silence_limit = 1e9)
      : network_(network) {
    static_cast<void>(device.open());
    device.place(Pose::translation(dvec3(0.0, 0.0, 0.005)));
    loop_.emplace(device, clock, patientOptionsFor(device, rate_hz, set_silence_limit));
    link_.emplace(*loop_, clock, describe(device), network_);
  }

  ForceLoop& loop() { return *loop_; }
  InMemoryLink& link() { return *link_; }
  const HapticState& state() const { return loop_->current(); }
  double force() const { return glm::length(state().force_D); }

  /// So many ticks, each noted for `max_force`, `max_step` and `free_force`.
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      const dvec3 before = state().force_D;
      link_->step();
      max_force = std::max(max_force, force());
      max_step = std::max(max_step, glm::length(state().force_D - before));
    }
  }

  void holdAt(double height) { link_->sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, height)), 0}); }

  /// So many ticks, with a new set of the floor at every `period`-th. With a `height_step` the hand goes by so much, m,
  /// in each, from 5 mm above the floor on.
  void saySets(int ticks, int period, double height_step = 0.0) {
    for (int i = 0; i < ticks; ++i) {
      if (height_step != 0.0) holdAt(0.005 + height_step * i);
      if (i % period == 0) link_->sendSet(floorSet(++sets_said));
      run(1);
    }
  }

  /// Forces on, gate and ramp run through, in free air 5 mm above the floor.
  void engage() {
    holdAt(0.005);
    link_->sendControl({.forces_enabled = true});
    link_->sendSet(floorSet(1));
    run(1500);
  }

  /// engage(), then the hand presses, without a blow at which the spring would yield, until everything rests: about
  /// 2.3 N on the floor.
  void press() {
    engage();
    for (int ms = 1; ms <= 150; ++ms) {
      holdAt(0.005 - 1e-4 * ms);
      run(1);
    }
    run(1350);
  }

  VirtualClock clock;
  SimulatedDevice device;
  double max_force = 0.0, max_step = 0.0;
  std::uint64_t sets_said = 0;  ///< For tests that count their sets.

 private:
  InMemoryLinkOptions network_;
  std::optional<ForceLoop> loop_;
  std::optional<InMemoryLink> link_;
};

}  // namespace hapticell::haptic
