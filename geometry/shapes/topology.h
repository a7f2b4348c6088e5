// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// How the triangles of a welded mesh are connected, according to a half-edge mesh (OpenMesh).
struct Topology {
  std::uint32_t shells = 0;  ///< Connected surfaces.
  std::uint32_t holes = 0;   ///< Closed loops of border edges.
  std::uint32_t border_edges = 0;
  std::uint32_t rejected_triangles =
      0;                         ///< Faces that do not fit (a third face at an edge, a face turned over); the other
                                 ///< counts exclude them.
  int euler_characteristic = 0;  ///< Vertices - edges + faces; 2 for a sphere, 0 for a torus.
};

/// Builds a temporary half-edge mesh and counts in it. Drawing and collision continue to use the given mesh.
Topology topologyOf(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
