// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/holding/ways_out.h"

namespace hapticell::manipulation {

/// The distance at which each pair of a held entity is felt: its safety distance, or less if the pair has been nearer
/// since the entity was taken. The entity must not be pushed out, only get no nearer. One thread.
class HeldBoundaries {
 public:
  /// Call it when the entity is taken: notes what it touches or starts inside. `state` outlives this.
  explicit HeldBoundaries(HeldState& state);

  /// Raises the boundaries of pairs that have come apart since, up to their safety distance.
  void raise();
  /// The present planes along which the entity may leave what it started inside.
  const std::vector<FreeingPlane>& freeingPlanes();

 private:
  void leadOut(std::span<const FreeMotion::PairDistance> near);

  HeldState& state_;
  WaysOut ways_out_;
  std::vector<double> gaps_;                    // Scratch: one per pair.
  std::vector<FreeMotion::PairDistance> near_;  // Scratch.
};

}  // namespace hapticell::manipulation
