// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// A second stylus in an engine's cell, with its own haptic server. It holds another entity, or the other hand of the
/// same mannequin (whose trunk is then locked: by::Hand::locks in both). At its next step each stylus uses what the
/// other one moved; both check exactly. Runs in the engine's thread.
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

  /// Adds what it holds, its near pairs and its force to the engine's snapshot.
  void addTo(SceneSnapshot& snapshot);

 private:
  std::unique_ptr<haptic::HapticLink> link_;
  ManipulationEngine& engine_;
  StylusHolder holder_;
};

}  // namespace hapticell::manipulation
