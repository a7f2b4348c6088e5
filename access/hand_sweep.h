// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "access/removal_way.h"

namespace hapticell::access {

/// Rigid shapes that move with the part: a hand with its fingers, a tool.
struct SweptShape {
  std::shared_ptr<const collision::MeshCollider> collider;
  Pose X_WP;  ///< While the part stands.
};

/// Whether they fit along a way.
struct HandSweep {
  bool fits = false;
  std::string blocked_by{};  ///< Name of what is in the way; empty: nothing.
  double at_m = 0.0;         ///< Way of the part until there.
  double clearance_m = 0.0;  ///< m that is left beside the glove, the least on the way, up to 0.1; below 0: it does not fit.
};

/// Sweeps the shapes with the part along its way, past all units but the part itself and those that are gone, with `glove`
/// (m) of room around them: checked continuously. Any thread.
HandSweep sweepHand(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way,
                    const std::vector<SweptShape>& shapes, double glove);

}  // namespace hapticell::access
