// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

/// A second stylus in the same cell, at a haptic server of its own, with an engine of its own: it holds another entity,
/// or the other hand of the same mannequin (whose trunk then stands still: by::Hand::locks in both). What either
/// moves counts for the other at its next step, checked exactly by both. One thread, that of the first engine.
class SecondStylus {
 public:
  SecondStylus(std::unique_ptr<haptic::HapticLink> link, const config::Configuration& configuration)
      : link_(std::move(link)), engine_(*link_, configuration) {}

  ManipulationEngine& engine() { return engine_; }

  /// After a step of `first`: takes over what that moved, makes its own step, hands over what it moved.
  void step(ManipulationEngine& first, std::int64_t now_ns);

  /// Adds what it holds, is near to and feels to the picture of `first`.
  void addTo(SceneSnapshot& snapshot);

 private:
  std::unique_ptr<haptic::HapticLink> link_;
  ManipulationEngine engine_;
};

}  // namespace hapticell::manipulation
