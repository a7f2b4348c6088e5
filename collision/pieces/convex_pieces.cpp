// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "collision/pieces/feature_blocks.h"
#include "collision/pieces/patch_merger.h"
#include "collision/pieces/pieces_on_demand.h"
#include "collision/pieces/surface_patches.h"

namespace hapticell::collision {
namespace {

double usualTolerance(const geometry::TriangleMesh& mesh) {
  return std::max(1e-6, 1e-5 * glm::length(mesh.bounds().size()));
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

std::optional<ConvexPiece> pieceOfPatch(const SurfaceGraph& graph, const Patch& patch) {
  auto hull = hullOfPatch(graph, patch);
  if (!hull && isConvexSurface(graph, patch)) hull = hullOfConvexSurface(graph, patch);
  if (!hull) return std::nullopt;
  ConvexPiece piece;
  piece.hull = std::move(*hull);
  piece.real_plane = realPlanes(graph, patch, piece.hull, 2.0 * graph.tolerance());
  piece.beyond_edges = graph.normalsBeyond(patch);
  piece.bounds = geometry::boundsOf(piece.hull.vertices);
  for (const auto triangle : patch.triangles) piece.triangles.push_back(graph.originalTriangle(triangle));
  sortIntoBlocks(piece);
  return piece;
}

ConvexPieces::ConvexPieces() = default;
ConvexPieces::~ConvexPieces() = default;

std::shared_ptr<const ConvexPieces> ConvexPieces::onDemand(std::shared_ptr<const MeshCollider> collider,
                                                           double tolerance) {
  auto result = std::make_shared<ConvexPieces>();
  result->tolerance_ = tolerance > 0.0 ? tolerance : usualTolerance(collider->mesh());
  result->bounds_ = collider->bounds();
  result->blocks_ = std::make_unique<const PiecesOnDemand>(std::move(collider), result->tolerance_);
  return result;
}

std::shared_ptr<const ConvexPieces> ConvexPieces::build(const geometry::TriangleMesh& mesh, double tolerance) {
  auto result = std::make_shared<ConvexPieces>();
  result->tolerance_ = tolerance > 0.0 ? tolerance : usualTolerance(mesh);
  const SurfaceGraph graph(mesh, result->tolerance_);
  result->surface_ = MeshCollider::build(graph.mesh());
  result->piece_of_.assign(graph.mesh().triangles.size(), 0);
  const auto add = [&](const Patch& patch) {
    auto piece = pieceOfPatch(graph, patch);
    if (!piece) return false;
    for (const auto triangle : patch.triangles) {
      result->piece_of_[triangle] = static_cast<std::uint32_t>(result->pieces_.size());
    }
    result->pieces_.push_back(std::move(*piece));
    return true;
  };
  for (const Patch& patch : convexPatches(graph, *result->surface_)) {
    if (add(patch)) continue;
    for (const auto triangle : patch.triangles) add(graph.patchOf({triangle}));
  }
  for (const ConvexPiece& piece : result->pieces_) result->bounds_.add(piece.bounds);
  return result;
}

}  // namespace hapticell::collision
