// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/trees/collider_build.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// The triangles worth searching, in their order, and how many were not, or are degenerate.
struct CountedTriangles {
  std::vector<std::uint32_t> kept;
  TriangleCensus census;
};
CountedTriangles countTriangles(const geometry::TriangleMesh& mesh);

/// The same mesh with vertices that are equal to the last bit kept once, where it has more than one and a half vertices
/// a triangle (STL files have three); else as it was. Triangles keep their indices.
geometry::TriangleMesh shareVertices(const geometry::TriangleMesh& mesh);

}  // namespace hapticell::collision
