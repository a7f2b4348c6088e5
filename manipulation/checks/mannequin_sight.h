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
      0.0;  ///< Share of the target's sample points that nothing hides from the point between the eyes, 0 to 1.
  mannequin::VisionZone zone = mannequin::VisionZone::kOutside;  ///< Of the target's middle.
  double distance = 0.0;                                         ///< m, to the middle.
  double clearance = 0.0;   ///< m that the line of sight to the middle keeps from the nearest other part; 0: it is cut.
  std::string hidden_by{};  ///< What hides most of it; empty: nothing does.
};

/// Casts rays from between the eyes to 27 points of the target's box, through everything else of the scene (the
/// mannequin's own body aside). Null scene entities are taken as they stand. Some milliseconds.
TargetSight sightOfTarget(const PreparedScene& scene, const workcell::Entity& mannequin,
                          const mannequin::Posture& posture, workcell::EntityId target);

}  // namespace hapticell::manipulation
