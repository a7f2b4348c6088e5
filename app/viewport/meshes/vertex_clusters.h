// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// The mesh with all vertices in a cell of a grid merged at their middle (Rossignac and Borrel, "Multi-resolution 3D
/// approximations for rendering complex scenes", 1993); `cells` along its longest side. One pass: about 0.1 s per
/// million triangles. What is thinner than a cell may vanish; no vertex moves further than a cell's diagonal. Any
/// thread.
geometry::TriangleMesh clustered(const geometry::TriangleMesh& mesh, int cells);

}  // namespace hapticell::app
