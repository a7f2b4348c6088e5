// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "collision/convex_hull.h"
#include "collision/mesh_collider.h"
#include "geometry/bounds.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::collision {

/// A run of neighbouring planes or edges of a hull and a box about them, for leaving out what is far away.
struct FeatureBlock {
  geometry::Bounds bounds;  ///< In the mesh's frame M.
  std::uint32_t first = 0;
  std::uint32_t end = 0;  ///< One past the last.
};

/// A patch of a mesh's surface that fills no free room when its convex hull is taken: what lies outside the hull of one
/// piece is decided by one group of separating directions (OR).
struct ConvexPiece {
  ConvexHull hull;  ///< In the mesh's frame M.
  std::vector<std::uint8_t>
      real_plane;  ///< Per plane of the hull: 1 where it is a face of the mesh, 0 where it only closes it.
  std::vector<dvec3> beyond_edges;  ///< Unit normals of the mesh's faces across convex edges of the patch.
  std::vector<FeatureBlock> plane_blocks;
  std::vector<FeatureBlock> edge_blocks;
  geometry::Bounds bounds;
  std::vector<std::uint32_t> triangles;  ///< Of the mesh given to build().
};

/// A mesh's surface cut into convex pieces: every triangle belongs to one piece, so two meshes are apart where every
/// pair of their pieces is. Immutable after build; any thread may read it.
class ConvexPieces {
 public:
  /// Cuts the surface of a soup (indices in range, coordinates finite). A convex mesh (box, cylinder, sphere) becomes
  /// one piece; elsewhere triangles are joined while their hull stays free of other surface by more than
  /// `tolerance` (m; 0 chooses 1e-5 of the size, at least a micrometre). Degenerate triangles are dropped.
  /// Meshes of more than kMostTriangles are not cut (it would take minutes and kilobytes a triangle): isCrowded().
  static constexpr std::size_t kMostTriangles = 200000;
  static std::shared_ptr<const ConvexPieces> build(const geometry::TriangleMesh& mesh, double tolerance = 0.0);

  const std::vector<ConvexPiece>& pieces() const { return pieces_; }
  const geometry::Bounds& bounds() const { return bounds_; }
  /// Too large to be cut: there are bounds, but no pieces and no surface. A query in whose zone it comes is incomplete.
  bool isCrowded() const { return crowded_; }
  /// The welded surface that the pieces were cut from; null for an empty mesh and a crowded one.
  const MeshCollider* surface() const { return surface_.get(); }
  /// The piece that holds a triangle of the surface.
  std::uint32_t pieceOf(std::uint32_t surface_triangle) const { return piece_of_[surface_triangle]; }
  const std::vector<std::uint32_t>& pieceOfEachTriangle() const { return piece_of_; }
  double tolerance() const { return tolerance_; }

 private:
  std::vector<ConvexPiece> pieces_;
  geometry::Bounds bounds_;
  std::shared_ptr<const MeshCollider> surface_;
  std::vector<std::uint32_t> piece_of_;
  double tolerance_ = 0.0;
  bool crowded_ = false;
};

}  // namespace hapticell::collision
