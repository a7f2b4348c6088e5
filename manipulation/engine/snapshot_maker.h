// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/engine/contact_watch.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/stylus_grip.h"
#include "manipulation/engine/stylus_input.h"

namespace hapticell::manipulation {

/// Makes the picture of what one stylus holds and feels. The manipulation thread's.
class SnapshotMaker {
 public:
  /// `cell` outlives it.
  explicit SnapshotMaker(const CellState& cell) : cell_(cell) {}

  /// Something else is held, or nothing.
  void forget() { near_.clear(); }
  /// Adds where everything stands that does not stand as in the document, and the pairs of what is held (distances are
  /// measured for it at most 30 times a second).
  void addEntities(StylusGrip& grip, const ContactWatch& contacts, SceneSnapshot& snapshot);
  /// Adds what is known of the stylus itself.
  static void addStylus(const StylusInput& input, const MotionMapping& mapping, SceneSnapshot& snapshot);
  /// What the snapshot has, in words: SceneSnapshot::status, or its problem.
  void describe(const StylusInput& input, const StylusGrip& grip, SceneSnapshot& snapshot) const;

 private:
  void addPairs(HeldEntity& held, const ContactWatch& contacts, SceneSnapshot& snapshot);
  Text sentenceOf(const HeldEntity& held, const SceneSnapshot& snapshot) const;

  const CellState& cell_;
  std::int64_t measured_ns_ = -1;
  std::vector<FreeMotion::PairDistance> near_;
};

/// A pair that was measured, as it is shown.
PairState shownPair(const HeldPair& pair, const collision::DistanceResult& measured, bool in_contact);

}  // namespace hapticell::manipulation
