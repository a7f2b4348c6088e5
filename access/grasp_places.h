// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "access/removal_scene.h"
#include "mannequin/posture/hands_to.h"

namespace hapticell::access {

/// A tool between hand and part: a straight one, such as a screwdriver or a socket on its extension.
struct Tool {
  double length = 0.0;  ///< m from the part to the middle of the hand; 0: none.
  double radius = 0.0;  ///< m
};

/// A place where a hand could take a unit.
struct GraspPlace {
  mannequin::HandTarget target;  ///< Where the centre of the grip goes: on the part, or at the tool's end.
  dvec3 p_WPart{0.0};            ///< On the part.
};

/// Places on the surface of a unit, on the sides of its own box and on its top, where the surface is met towards the
/// box's middle (or, at a hole, nearest to it); the hand comes from outside. With a tool the hand is at its end. Each once;
/// from above first. Any thread.
std::vector<GraspPlace> graspPlaces(const RemovalUnit& unit, const Tool& tool);

/// The grasp (setGrasp()) that a part of that size is taken with: "pinch" up to 60 mm, "power" where a hand goes round
/// it, else "flat".
std::string_view graspFor(const RemovalUnit& unit, const Tool& tool);

}  // namespace hapticell::access
