// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "haptic/server/in_memory_link.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {

/// Any device under a real force loop in virtual time, with a client that puts a floor under it.
struct ContactRig {
  explicit ContactRig(Device& device)
      : loop(device, clock, patientOptionsFor(device)), link(loop, clock, describe(device)) {}

  /// So many ticks; `each` is called before each. Notes the greatest force step.
  template <typename Each>
  void run(int ticks, Each&& each) {
    for (int i = 0; i < ticks; ++i) {
      each();
      const dvec3 before = loop.current().force_D;
      link.step();
      max_step = std::max(max_step, glm::length(loop.current().force_D - before));
    }
  }
  void run(int ticks) {
    run(ticks, [] {});
  }

  /// A floor at `height` and forces on.
  void engage(double height) {
    link.sendControl({.forces_enabled = true});
    link.sendSet(floorSet(++sequence, height));
    run(1500);
  }
  /// As a user who switches forces off and on again.
  void switchOnAgain(double height) {
    link.sendControl({.forces_enabled = false});
    run(20);
    engage(height);
  }

  double force() const { return glm::length(loop.current().force_D); }

  VirtualClock clock;
  ForceLoop loop;
  InMemoryLink link;
  std::uint64_t sequence = 0;
  double max_step = 0.0;
};

}  // namespace hapticell::haptic
