// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/engine/contact_watch.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/stylus_grip.h"
#include "manipulation/engine/stylus_input.h"

namespace hapticell::manipulation {

/// Makes the snapshot of what one stylus holds and feels. Manipulation thread only.
class SnapshotMaker {
 public:
  /// `cell` outlives it.
  explicit SnapshotMaker(const CellState& cell) : cell_(cell) {}

  /// Call it if another entity or none is held.
  void forget() { near_.clear(); }
  /// Adds all placements that differ from the document, and the pairs of the held entity (measured at most 30 times a
  /// second).
  void addEntities(StylusGrip& grip, const ContactWatch& contacts, SceneSnapshot& snapshot);
  /// Adds the state of the stylus.
  static void addStylus(const StylusInput& input, const MotionMapping& mapping, SceneSnapshot& snapshot);
  /// Sets SceneSnapshot::status and its problem.
  void describe(const StylusInput& input, const StylusGrip& grip, SceneSnapshot& snapshot) const;

 private:
  void addPairs(HeldEntity& held, const ContactWatch& contacts, SceneSnapshot& snapshot);
  Text sentenceOf(const HeldEntity& held, const SceneSnapshot& snapshot) const;

  const CellState& cell_;
  std::int64_t measured_ns_ = -1;
  std::vector<FreeMotion::PairDistance> near_;
};

/// Converts a measured pair for display.
PairState shownPair(const HeldPair& pair, const collision::DistanceResult& measured, bool in_contact);

}  // namespace hapticell::manipulation
