// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// How a part A comes out of a part B that it intersects, or lies inside of.
struct FreeingShift {
  bool found = false;       ///< False when they do not collide, or nothing tried frees them.
  double depth = 0.0;       ///< Metres: A moved this far along the direction is free, by kFreeGap.
  dvec3 direction_W{0.0};   ///< Unit.
  bool by_winding = false;  ///< One of the meshes is open: what is inside was judged by the winding number.
};

/// This far (m) from B's surface A lies after the shift.
inline constexpr double kFreeGap = 1e-6;

/// The shortest shift found that frees A: along the normals of the triangles that intersect, the line of the centres,
/// the world's axes, and then the direction in which the parts were nearest once free. Every answer is checked: shifted
/// so, A collides no more (ProximityQuery::collides), nor, for open soups, is a point of one inside the other by the
/// generalised winding number (Jacobson et al. 2013). Not proven to be the least; for convex parts it is within a few
/// percent. Milliseconds; allocates; thread of the query.
FreeingShift freeingShift(ProximityQuery& query, const Pose& X_WA, const Pose& X_WB);

/// The generalised winding number of a mesh about a point p_MQ off its surface: 1 inside of what is closed and turned
/// outwards, 0 outside, in between for soups with holes. Looks at all triangles.
double windingNumber(const geometry::TriangleMesh& mesh, const dvec3& p_MQ);

}  // namespace hapticell::collision
