// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// A mesh that has another shape in the next picture: it brings what need not be made ready anew then, its normals and
/// coarser triangles over the same vertices. The mesh of every RenderItem that is `smooth` is one.
struct PosedMesh : geometry::TriangleMesh {
  struct Step {
    std::vector<std::uint32_t> indices;  ///< Three a triangle; the first step's are the mesh's own.
    double error = 0.0;                  ///< As DetailStep's, m.
  };
  std::vector<fvec3> normals;  ///< Unit, one a vertex.
  std::shared_ptr<const std::vector<Step>> steps;
};

}  // namespace hapticell::app
