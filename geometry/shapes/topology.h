// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// How the triangles of a welded mesh are connected, as in a half-edge mesh (OpenMesh).
struct Topology {
  std::uint32_t shells = 0;  ///< Connected surfaces.
  std::uint32_t holes = 0;   ///< Closed loops of border edges.
  std::uint32_t border_edges = 0;
  std::uint32_t rejected_triangles =
      0;                         ///< Faces that do not fit (a third face at an edge, a face turned over); the other
                                 ///< counts exclude them.
  int euler_characteristic = 0;  ///< Vertices - edges + faces; 2 for a sphere, 0 for a torus.
  bool closed = false;           ///< isClosed() of all triangles.
  /// For each shell, join each of its triangles to one fixed vertex of the shell, and divide the signed sum of the
  /// volumes of these tetrahedra by the sum of their absolute values. This is the smallest of these ratios: near 1 for
  /// most bodies, negative if the triangles face inwards. 0 unless each edge has two triangles that face the same way.
  double least_volume_share = 0.0;
};

/// Counts in a surface whose corners are all surrounded by one ring or fan of triangles; in parts of it that are not
/// like that, in a temporary half-edge mesh of OpenMesh, which takes longer. The results are the same. Drawing and
/// collision continue to use the given mesh.
Topology topologyOf(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
