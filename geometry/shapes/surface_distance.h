// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// How far two surfaces are apart, and where.
struct SurfaceDistance {
  double distance = 0.0;  ///< m
  dvec3 p{0.0};           ///< The point of one of them that is farthest from the other.
};

/// The largest distance from a corner, or from points inside each triangle, of one mesh to the other's
/// surface, both ways; infinite where one of them is empty. By triangles in a grid of cells: shares nothing with the
/// trees of collision/ nor with what simplifies meshes, so that it can measure what they made. Any thread.
SurfaceDistance surfaceDistance(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace hapticell::geometry
