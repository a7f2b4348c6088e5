// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// A short stretch of the motion of two meshes A and B, in the world.
struct SweptPair {
  Pose X_WA0, X_WA1;
  Pose X_WB0, X_WB1;
  double reach = 0.0;  ///< No two points of A and B come nearer to each other by more than this (m) on the way.
  double bend = 0.0;   ///< Largest deviation of the paths from the straight line between their ends (m), A and B
                       ///< together.
};

/// Whether A and B are proven to stay `least` (m) apart throughout; false means "not proven".
///
/// Every pair of triangles that could meet needs an axis along which they are apart at both ends of the stretch: on a
/// fixed axis the gap between convex shapes whose points move straight is concave in time, so it is least at an end.
/// The axes tried are the two faces' normals and the line of the nearest points. Gives up after 1000 pairs. Any thread;
/// no allocation.
bool staysApart(const MeshCollider& a, const MeshCollider& b, const SweptPair& motion, double least);

}  // namespace hapticell::collision
