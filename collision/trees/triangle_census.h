// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/trees/collider_build.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// The triangles to search, in their order, and the counts of the unusual ones.
struct CountedTriangles {
  std::vector<std::uint32_t> kept;
  TriangleCensus census;
};
CountedTriangles countTriangles(const geometry::TriangleMesh& mesh);

/// If the mesh has more than 1.5 vertices per triangle (STL files have 3), merges vertices that are equal to the last
/// bit; else the mesh is unchanged. Triangles keep their indices.
geometry::TriangleMesh shareVertices(const geometry::TriangleMesh& mesh);

}  // namespace hapticell::collision
