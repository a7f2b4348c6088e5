// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "collision/pieces/convex_hull.h"
#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/bounds.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Consecutive neighbouring planes or edges of a hull and a box around them, so that distant ones can be skipped.
struct FeatureBlock {
  geometry::Bounds bounds;  ///< In the mesh's frame M.
  std::uint32_t first = 0;
  std::uint32_t end = 0;  ///< One past the last.
};

/// A patch of a mesh's surface whose convex hull covers no free space. One group of separating directions (OR) decides
/// what lies outside the hull of one piece.
struct ConvexPiece {
  ConvexHull hull;  ///< In the mesh's frame M.
  std::vector<std::uint8_t>
      real_plane;  ///< Per plane of the hull: 1 if it is a face of the mesh, 0 if it only closes the hull.
  std::vector<dvec3> beyond_edges;  ///< Unit normals of the mesh's faces across convex edges of the patch.
  std::vector<FeatureBlock> plane_blocks;
  std::vector<FeatureBlock> edge_blocks;
  geometry::Bounds bounds;
  std::vector<std::uint32_t> triangles;  ///< Indices in the mesh given to build().
};

class PiecesOnDemand;
class SurfaceGraph;
struct Patch;

/// The piece of a patch whose hull contains no other surface; empty if rounding makes the hull wrong.
std::optional<ConvexPiece> pieceOfPatch(const SurfaceGraph& graph, const Patch& patch);

/// A mesh's surface cut into convex pieces: every triangle belongs to one piece, so two meshes are apart if every pair
/// of their pieces is. Immutable after build; any thread may read it.
class ConvexPieces {
 public:
  /// Cuts the surface of a soup (indices in range, coordinates finite). A convex mesh (box, cylinder, sphere) becomes
  /// one piece; in other meshes triangles are joined as long as no other surface lies in their hull deeper than
  /// `tolerance` (m; 0 chooses 1e-5 of the size, at least a micrometre). Degenerate triangles are dropped. It takes
  /// about 40 microseconds and a kilobyte per triangle; cut large meshes with onDemand() instead.
  static std::shared_ptr<const ConvexPieces> build(const geometry::TriangleMesh& mesh, double tolerance = 0.0);

  /// Cuts nothing yet; queries cut what they come near (see PiecesOnDemand). The object then has blocks() instead of
  /// pieces().
  static std::shared_ptr<const ConvexPieces> onDemand(std::shared_ptr<const MeshCollider> collider,
                                                      double tolerance = 0.0);

  ConvexPieces();
  ~ConvexPieces();

  const std::vector<ConvexPiece>& pieces() const { return pieces_; }
  const geometry::Bounds& bounds() const { return bounds_; }
  /// Null if the mesh was cut as a whole.
  const PiecesOnDemand* blocks() const { return blocks_.get(); }
  /// The welded surface that the pieces were cut from; null for an empty mesh and for a mesh that is cut on demand.
  const MeshCollider* surface() const { return surface_.get(); }
  /// The piece that contains a triangle of the surface.
  std::uint32_t pieceOf(std::uint32_t surface_triangle) const { return piece_of_[surface_triangle]; }
  const std::vector<std::uint32_t>& pieceOfEachTriangle() const { return piece_of_; }
  double tolerance() const { return tolerance_; }

 private:
  std::vector<ConvexPiece> pieces_;
  geometry::Bounds bounds_;
  std::shared_ptr<const MeshCollider> surface_;
  std::vector<std::uint32_t> piece_of_;
  double tolerance_ = 0.0;
  std::unique_ptr<const PiecesOnDemand> blocks_;
};

}  // namespace hapticell::collision
