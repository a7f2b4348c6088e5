// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "access/removal_scene.h"

namespace hapticell::access {

/// Directions (unit, in the cell) in which a unit might leave straight: the axes of the cell and of the unit's own
/// frame, the axes of its recognised cylinders and cones and the normals of its large planes, the normals at which it
/// touches its neighbours and the axes of their bores there, and the diagonals. Each once (within 1 deg), those that
/// leave the box soonest first; at most 60.
std::vector<dvec3> removalDirections(const RemovalScene& scene, std::size_t unit);

}  // namespace hapticell::access
