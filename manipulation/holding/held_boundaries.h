// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/holding/ways_out.h"

namespace hapticell::manipulation {

/// From which distance on each pair of a held entity is felt: its safety distance, or less while it is nearer than that
/// since it was taken; it must not be thrown out, only get no nearer. One thread.
class HeldBoundaries {
 public:
  /// As the entity is taken: what it touches or starts inside of is noted. `state` outlives this.
  explicit HeldBoundaries(HeldState& state);

  /// Pairs that have come apart since get back what they lack of their safety distance.
  void raise();
  /// Where what the entity started inside of is let out now.
  const std::vector<FreeingPlane>& freeingPlanes();

 private:
  void leadOut(std::span<const FreeMotion::PairDistance> near);

  HeldState& state_;
  WaysOut ways_out_;
  std::vector<double> gaps_;                    // Scratch: one a pair.
  std::vector<FreeMotion::PairDistance> near_;  // Scratch.
};

}  // namespace hapticell::manipulation
