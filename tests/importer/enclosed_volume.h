// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::test {

/// Of a closed mesh whose triangles turn outwards (divergence theorem); negative if they turn inwards.
inline double enclosedVolume(const geometry::TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += glm::dot(mesh.vertices[t[0]], glm::cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
  return volume;
}

}  // namespace hapticell::test
