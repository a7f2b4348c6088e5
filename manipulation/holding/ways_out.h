// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "manipulation/holding/held_state.h"

namespace hapticell::collision {
struct FreeingShift;
}

namespace hapticell::manipulation {

/// Pairs that intersected other than by a hair when the entity was taken: each is led out by one plane, as facets deep
/// inside say nothing of use. One thread.
class WaysOut {
 public:
  /// Looks at the pairs that are `near` as the entity is taken; notes what it finds, and such pairs are not felt
  /// otherwise.
  void find(HeldState& state, std::span<const FreeMotion::PairDistance> near);
  /// Where they have come apart the usual contacts hold from now on.
  void update(HeldState& state);
  /// As the last update() found them.
  const std::vector<FreeingPlane>& planes() const { return planes_; }

 private:
  struct WayOut {
    FreeingPlane plane;
    dvec3 p_PC{0.0};       ///< Of the part, that is watched.
    double reached = 0.0;  ///< m along the plane's normal: it goes no deeper again.
  };
  static void note(HeldState& state, std::uint32_t pair, const collision::FreeingShift& shift);

  std::vector<WayOut> ways_;
  std::vector<FreeingPlane> planes_;
};

}  // namespace hapticell::manipulation
