// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// How to move a part A out of a part B that it intersects or lies inside.
struct FreeingShift {
  bool found = false;       ///< False when they do not collide, or nothing tried frees them.
  double depth = 0.0;       ///< Metres: if A is moved this far along the direction, it is free by kFreeGap.
  /// Metres: moved this far, along some direction, their surfaces are apart. Less than `depth` only where a mesh is open
  /// and A may still be inside: a link without a bottom that stands on a table. Infinite when nothing tried does it.
  double surface_depth = std::numeric_limits<double>::infinity();
  dvec3 direction_W{0.0};   ///< Unit.
  bool by_winding = false;  ///< One of the meshes is open: what is inside was judged by the winding number.
};

/// m: distance of A from B's surface after the shift, kLeastClearance, so that the next motion does not begin
/// colliding. Half: it may; twice: a depth that is 1 um more.
inline constexpr double kFreeGap = 1e-6;

/// The shortest shift found that frees A: along the normals of the triangles that intersect, the line of the centres,
/// the world's axes, and then the direction in which the parts were nearest once free. Every answer is checked: after
/// the shift A does not collide (ProximityQuery::collides()) and, for open soups, no point of one is inside the other
/// by the generalised winding number (Jacobson et al. 2013). The shift is not proven to be the shortest; for convex
/// parts it is within a few percent. Milliseconds; allocates; thread of the query.
FreeingShift freeingShift(ProximityQuery& query, const Pose& X_WA, const Pose& X_WB);

/// The generalised winding number of a mesh about a point p_MQ that is not on its surface: 1 inside a closed mesh that
/// faces outward, 0 outside, in between for soups with holes. It uses all triangles.
double windingNumber(const geometry::TriangleMesh& mesh, const dvec3& p_MQ);

}  // namespace hapticell::collision
