// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "manipulation/holding/held_state.h"

namespace hapticell::collision {
struct FreeingShift;
}

namespace hapticell::manipulation {

/// Pairs that intersected by more than a hair when the entity was taken: each is guided out by one plane, because
/// facets deep inside give no useful direction. One thread.
class WaysOut {
 public:
  /// Checks the pairs that are `near` when the entity is taken, notes the intersecting ones, and switches off their
  /// other constraints.
  void find(HeldState& state, std::span<const FreeMotion::PairDistance> near);
  /// Pairs that have come apart use the usual contacts from now on.
  void update(HeldState& state);
  /// The planes of the last update().
  const std::vector<FreeingPlane>& planes() const { return planes_; }

 private:
  struct WayOut {
    FreeingPlane plane;
    dvec3 p_PC{0.0};       ///< The watched point of the part.
    double reached = 0.0;  ///< m along the plane's normal; the pair must not get deeper again.
  };
  static void note(HeldState& state, std::uint32_t pair, const collision::FreeingShift& shift);

  std::vector<WayOut> ways_;
  std::vector<FreeingPlane> planes_;
};

}  // namespace hapticell::manipulation
