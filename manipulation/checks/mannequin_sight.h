// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "manipulation/scene/prepared_scene.h"
#include "mannequin/posture/posture.h"
#include "mannequin/posture/vision.h"

namespace hapticell::manipulation {

/// How well a mannequin sees an entity.
struct TargetSight {
  double seen =
      0.0;  ///< Share of the target's sample points that are visible from the point between the eyes, 0 to 1.
  mannequin::VisionZone zone = mannequin::VisionZone::kOutside;  ///< Zone of the target's middle.
  double distance = 0.0;                                         ///< m, to the middle.
  double clearance = 0.0;   ///< m between the line of sight to the middle and the nearest other part; 0: it is blocked.
  std::string hidden_by{};  ///< The part that hides most of it; empty: not hidden.
};

/// Casts rays from between the eyes to 27 points of the target's box, through everything else in the scene except the
/// mannequin's own body. Null scene entities are used at their present pose. Takes some milliseconds.
TargetSight sightOfTarget(const PreparedScene& scene, const workcell::Entity& mannequin,
                          const mannequin::Posture& posture, workcell::EntityId target);

}  // namespace hapticell::manipulation
