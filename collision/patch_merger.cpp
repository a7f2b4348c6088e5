// SPDX-License-Identifier: Apache-2.0
#include "collision/patch_merger.h"

#include <cmath>

#include "collision/convex_hull.h"

namespace hapticell::collision {

bool isConvexSurface(const SurfaceGraph& graph, const Patch& patch) {
  const double tolerance = graph.tolerance();
  for (const auto triangle : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (graph.neighbour(triangle, k) != SurfaceGraph::kNone && !graph.isConvexAcross(triangle, k)) return false;
    }
  }
  for (const auto triangle : patch.triangles) {
    const dvec3& nhat = graph.normal(triangle);
    const double offset = glm::dot(nhat, graph.mesh().corner(triangle, 0));
    for (const auto vertex : patch.vertices) {
      if (glm::dot(nhat, graph.mesh().vertices[vertex]) > offset + tolerance) return false;
    }
  }
  return true;
}

std::vector<Patch> mergedPatches(const SurfaceGraph& graph, const Patch& component) {
  std::vector<Patch> patches;
  for (const auto triangle : component.triangles) patches.push_back(graph.patchOf({triangle}));
  return patches;
}

}  // namespace hapticell::collision
