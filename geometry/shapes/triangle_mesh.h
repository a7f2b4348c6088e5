// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/shapes/bounds.h"

namespace hapticell::geometry {

using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle soup in its own frame M, metres. Drawing and collision both use it.
///
/// CAD meshes are soups: edges with one or three triangles, duplicates and open borders are all allowed. Indices are
/// within range and coordinates finite; readers check that. The counter-clockwise side faces outward.
struct TriangleMesh {
  std::vector<dvec3> vertices;      ///< p_MV of each vertex.
  std::vector<Triangle> triangles;  ///< Three vertex indices each.

  dvec3 corner(std::uint32_t triangle, int corner_index) const {
    return vertices[triangles[triangle][static_cast<std::size_t>(corner_index)]];
  }
  std::array<dvec3, 3> corners(std::uint32_t triangle) const {
    return {corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
  }
  Bounds bounds() const;
};

/// What cleaning a soup removed. The user sees each number; nothing is dropped silently.
struct WeldReport {
  std::uint32_t merged_vertices = 0;
  std::uint32_t degenerate_triangles = 0;  ///< Dropped: two equal corners or no area.
  std::uint32_t duplicate_triangles = 0;   ///< Dropped: the same three corners as an earlier one.
};

/// Merges vertices closer than `tolerance` (m), drops degenerate and duplicate triangles and unused vertices.
WeldReport weld(TriangleMesh& mesh, double tolerance);

/// The usual tolerance for weld(): 1e-6 of the largest coordinate, or of the size if less.
double weldTolerance(const TriangleMesh& mesh);

/// Appends `part`, placed by X_AB, to `whole` (given in A).
void append(TriangleMesh& whole, const TriangleMesh& part_B, const Pose& X_AB);

}  // namespace hapticell::geometry
