// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/vertex_clusters.h"

#include <algorithm>

namespace hapticell::app {

geometry::TriangleMesh clustered(const geometry::TriangleMesh& mesh, int cells) {
  geometry::TriangleMesh result;
  const geometry::Bounds bounds = mesh.bounds();
  if (bounds.isEmpty()) return result;
  const dvec3 size = bounds.size();
  const double cell = std::max(std::max({size.x, size.y, size.z}) / cells, 1e-12);
  std::size_t count[3];
  for (int i = 0; i < 3; ++i) count[i] = static_cast<std::size_t>(size[i] / cell) + 1;
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> at(count[0] * count[1] * count[2], kNone), cluster(mesh.vertices.size());
  std::vector<double> members;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const dvec3 place = (mesh.vertices[v] - bounds.min) / cell;
    std::size_t which = 0;
    for (int i = 0; i < 3; ++i) which = which * count[i] + std::min(static_cast<std::size_t>(place[i]), count[i] - 1);
    if (at[which] == kNone) {
      at[which] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.emplace_back(0.0);
      members.push_back(0.0);
    }
    cluster[v] = at[which];
    result.vertices[cluster[v]] += mesh.vertices[v];
    members[cluster[v]] += 1.0;
  }
  for (std::size_t i = 0; i < members.size(); ++i) result.vertices[i] /= members[i];
  for (const geometry::Triangle& triangle : mesh.triangles) {
    const geometry::Triangle t{cluster[triangle[0]], cluster[triangle[1]], cluster[triangle[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.triangles.push_back(t);
  }
  return result;
}

}  // namespace hapticell::app
