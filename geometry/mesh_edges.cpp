// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_edges.h"

#include <algorithm>

namespace hapticell::geometry {

std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const Triangle& t = mesh.triangles[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      if (from != to) uses.push_back({std::min(from, to), std::max(from, to), triangle, from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle < b.triangle;
  });
  return uses;
}

std::vector<dvec3> triangleNormals(const TriangleMesh& mesh) {
  std::vector<dvec3> normals;
  normals.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0);
    const dvec3 area = glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a);
    const double length = glm::length(area);
    normals.push_back(length > 0.0 ? area / length : dvec3(0.0));
  }
  return normals;
}

std::size_t endOfEdge(const std::vector<EdgeUse>& uses, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < uses.size() && uses[end].sameEdge(uses[begin])) ++end;
  return end;
}

bool isConnected(const std::vector<EdgeUse>& uses, std::size_t begin, std::size_t end) {
  return end - begin == 2 && uses[begin].forward != uses[begin + 1].forward;
}

}  // namespace hapticell::geometry
