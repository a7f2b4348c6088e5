// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// How a part moves on a stretch, forward and backward from the pose in its middle: the point p goes by any share from
/// -1 to 1 of d_W + turn_W x (p - c), where c is the middle of the mesh's sphere (MeshCollider::center). All parts of a
/// motion go by the same share.
struct PartSweep {
  dvec3 d_W{0.0};     ///< m
  dvec3 turn_W{0.0};  ///< rad
};

/// A part in the middle of a stretch.
struct SweptPose {
  const Pose& X_WP;
  PartSweep sweep{};
};

}  // namespace hapticell::collision
