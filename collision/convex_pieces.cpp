// SPDX-License-Identifier: Apache-2.0
#include "collision/convex_pieces.h"

#include <algorithm>
#include <cmath>

#include "collision/surface_patches.h"

namespace hapticell::collision {
namespace {

constexpr double kShellThickness = 1e-5;  // given to flat patches, metres; less on small meshes

std::optional<ConvexHull> hullOfPatch(const SurfaceGraph& graph, const Patch& patch, double tolerance) {
  std::vector<dvec3> points;
  for (const auto vertex : patch.vertices) points.push_back(graph.mesh().vertices[vertex]);
  const double fine = 0.01 * tolerance;
  if (auto hull = convexHull(points, fine); hull && !graph.isFlat(patch)) return hull;
  const std::size_t count = points.size();
  const double thickness = std::min(kShellThickness, 0.01 * graph.size());
  const dvec3 inward = -thickness * graph.normal(patch.triangles.front());
  for (std::size_t i = 0; i < count; ++i) points.push_back(points[i] + inward);
  return convexHull(points, std::min(fine, 1e-4 * thickness));
}

std::vector<std::uint8_t> realPlanes(const SurfaceGraph& graph, const Patch& patch, const ConvexHull& hull,
                                     double tolerance) {
  std::vector<std::uint8_t> real(hull.planes.size(), 0);
  for (const auto triangle : patch.triangles) {
    for (std::size_t i = 0; i < hull.planes.size(); ++i) {
      const HullPlane& plane = hull.planes[i];
      if (real[i] != 0 || glm::dot(plane.nhat, graph.normal(triangle)) < 0.9) continue;
      double off = 0.0;
      for (int k = 0; k < 3; ++k) {
        off = std::max(off, std::abs(glm::dot(plane.nhat, graph.mesh().corner(triangle, k)) - plane.offset));
      }
      if (off <= tolerance) real[i] = 1;
    }
  }
  return real;
}

}  // namespace

std::shared_ptr<const ConvexPieces> ConvexPieces::build(const geometry::TriangleMesh& mesh, double tolerance) {
  auto result = std::make_shared<ConvexPieces>();
  const double size = glm::length(mesh.bounds().size());
  result->tolerance_ = tolerance > 0.0 ? tolerance : std::max(1e-6, 1e-5 * size);
  const SurfaceGraph graph(mesh, result->tolerance_);
  for (const Patch& patch : convexPatches(graph)) {
    auto hull = hullOfPatch(graph, patch, result->tolerance_);
    if (!hull) continue;
    ConvexPiece piece;
    piece.hull = std::move(*hull);
    piece.real_plane = realPlanes(graph, patch, piece.hull, 2.0 * result->tolerance_);
    piece.beyond_edges = graph.normalsBeyond(patch);
    piece.bounds = geometry::boundsOf(piece.hull.vertices);
    for (const auto triangle : patch.triangles) piece.triangles.push_back(graph.originalTriangle(triangle));
    result->bounds_.add(piece.bounds);
    result->pieces_.push_back(std::move(piece));
  }
  return result;
}

}  // namespace hapticell::collision
