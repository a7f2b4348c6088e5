// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// How the triangles of a welded mesh hang together, as a half-edge mesh (OpenMesh) sees them.
struct Topology {
  std::uint32_t shells = 0;  ///< Connected surfaces.
  std::uint32_t holes = 0;   ///< Closed loops of border edges.
  std::uint32_t border_edges = 0;
  std::uint32_t rejected_triangles =
      0;                         ///< Did not fit (a third face at an edge, a face turned over): left out of the rest.
  int euler_characteristic = 0;  ///< Vertices - edges + faces; 2 for a sphere, 0 for a torus.
};

/// Builds a half-edge mesh beside the soup and looks at it. The soup stays the truth for drawing and collision.
Topology topologyOf(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
