// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace hapticell::geometry {

/// One side of a triangle as a use of the edge between two vertices.
struct EdgeUse {
  std::uint32_t low = 0;   ///< The smaller vertex index.
  std::uint32_t high = 0;  ///< The larger one.
  std::uint32_t triangle = 0;
  bool forward = false;  ///< The triangle runs from low to high.

  bool sameEdge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles, those of one edge beside each other. The mesh should be welded. Sides of no length (the
/// same vertex twice) are left out.
std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh);

/// Unit normals of the triangles; zero for those without area.
std::vector<dvec3> triangleNormals(const TriangleMesh& mesh);

/// Where one edge's uses end that begin at `begin`.
std::size_t endOfEdge(const std::vector<EdgeUse>& uses, std::size_t begin);

/// True when the uses begin .. end - 1 are two triangles that run opposite ways: an ordinary inner edge of a surface.
bool isConnected(const std::vector<EdgeUse>& uses, std::size_t begin, std::size_t end);

}  // namespace hapticell::geometry
