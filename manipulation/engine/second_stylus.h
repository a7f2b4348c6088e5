// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// A second stylus in the cell of an engine, at a haptic server of its own: it holds another entity, or the other hand
/// of the same mannequin (whose trunk then stands still: by::Hand::locks in both). What either moves counts for the
/// other at its next step, checked exactly by both. One thread, that of the engine.
class SecondStylus {
 public:
  /// `engine` outlives it, and has one of these at a time.
  SecondStylus(std::unique_ptr<haptic::HapticLink> link, ManipulationEngine& engine);
  ~SecondStylus();
  SecondStylus(const SecondStylus&) = delete;
  SecondStylus& operator=(const SecondStylus&) = delete;

  StylusHolder& holder() { return holder_; }

  /// After a step of the engine, see ManipulationEngine::stepSecond().
  void step(std::int64_t now_ns) { engine_.stepSecond(now_ns); }

  /// Adds what it holds, is near to and feels to the picture of the engine.
  void addTo(SceneSnapshot& snapshot);

 private:
  std::unique_ptr<haptic::HapticLink> link_;
  ManipulationEngine& engine_;
  StylusHolder holder_;
};

}  // namespace hapticell::manipulation
