// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::app {

/// A mesh whose shape changes from picture to picture. Contains the data that need not be computed each time: normals,
/// and coarser triangles over the same vertices. Every `smooth` RenderItem has such a mesh.
struct PosedMesh : geometry::TriangleMesh {
  struct Step {
    std::vector<std::uint32_t> indices;  ///< Three per triangle; the first step's are the mesh's own.
    double error = 0.0;                  ///< As in DetailStep, m.
  };
  std::vector<fvec3> normals;  ///< Unit, one per vertex.
  std::shared_ptr<const std::vector<Step>> steps;
};

}  // namespace hapticell::app
