// SPDX-License-Identifier: Apache-2.0
#include "geometry/feature_edges.h"

#include <cmath>
#include <optional>

#include "geometry/mesh_edges.h"

namespace hapticell::geometry {

std::vector<FeatureEdge> featureEdges(const TriangleMesh& mesh, double crease_angle) {
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
  const std::vector<dvec3> normals = triangleNormals(mesh);
  const double flattest = std::cos(crease_angle);
  std::vector<FeatureEdge> edges;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    end = endOfEdge(uses, begin);
    std::optional<FeatureEdge::Kind> kind;
    if (end - begin == 1) {
      kind = FeatureEdge::Kind::kBorder;
    } else if (!isConnected(uses, begin, end)) {
      kind = FeatureEdge::Kind::kNonManifold;
    } else {
      const dvec3 a = normals[uses[begin].triangle], b = normals[uses[begin + 1].triangle];
      const bool both_have_area = glm::dot(a, a) > 0.0 && glm::dot(b, b) > 0.0;
      if (both_have_area && glm::dot(a, b) < flattest) kind = FeatureEdge::Kind::kCrease;
    }
    if (kind) edges.push_back({{uses[begin].low, uses[begin].high}, *kind});
  }
  return edges;
}

}  // namespace hapticell::geometry
