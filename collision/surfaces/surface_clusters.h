// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Fills mesh, neighbour, normals, component and closed of a surface: welded, without degenerate and duplicate
/// triangles. Triangles are neighbours only across an edge that exactly these two use in opposite directions.
RecognisedSurface connectedSurface(const geometry::TriangleMesh& mesh);

/// Connected triangles in one plane.
struct PlanarClusters {
  std::vector<std::uint32_t> cluster_of;              ///< Per triangle.
  std::vector<std::vector<std::uint32_t>> triangles;  ///< Per cluster; the largest triangle first.
  std::vector<double> areas;                          ///< Per cluster, m2.
};

/// Assigns every triangle to one cluster, flooding from the largest triangles; all vertices are within `tolerance` (m)
/// of its plane.
PlanarClusters planarClusters(const RecognisedSurface& surface, double tolerance);

double areaOf(const geometry::TriangleMesh& mesh, std::uint32_t triangle);
dvec3 middleOf(const geometry::TriangleMesh& mesh, std::uint32_t triangle);

}  // namespace hapticell::collision
