// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// How far two surfaces are apart, and where.
struct SurfaceDistance {
  double distance = 0.0;  ///< m
  dvec3 p{0.0};           ///< The point of one of them that is farthest from the other.
};

/// The largest distance from the corners and sample points of each mesh's triangles to the other mesh's surface;
/// infinite if one mesh is empty. It searches a grid of cells. It shares no code with the trees of collision/ or with
/// mesh simplification, so it can check their results. Any thread.
SurfaceDistance surfaceDistance(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace hapticell::geometry
