// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "access/removal_scene.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::access {

/// Measures the promises of a removal, as written, on the full meshes by points and single distances (none of the motion
/// checks that found it): it begins where the part stands, ends out of the box, and points on the surfaces (corners,
/// and along edges) of the part and of what is left never go deeper into each other than twice the tolerance. Looked at
/// every millimetre of motion.
Promises removalPromises(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                         const trajectory::Trajectory& written);

}  // namespace hapticell::access
