// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "access/removal_scene.h"
#include "access/removal_way.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::access {

/// Measures the promises of a removal, as written, on the full meshes by points and single distances (none of the motion
/// checks that found it): it begins where the part stands, ends out of the box, and points on the surfaces (corners,
/// and along edges) of the part and of what is left never go deeper into each other than twice the tolerance. Looked at
/// every millimetre of motion.
Promises removalPromises(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                         const trajectory::Trajectory& written);

/// A way as a motion of `speed` m/s, for a program to keep: written to a temporary file, read back and measured by
/// removalPromises(). What is returned is what was read. Errors: a missed promise, with what to do; no temporary file can
/// be written. Any thread; may take seconds.
Expected<trajectory::Trajectory> keptMotion(const RemovalScene& scene, std::size_t unit, UnitSet gone,
                                            const RemovalWay& way, double speed);

}  // namespace hapticell::access
