// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/system/error.h"
#include "geometry/shapes/triangle_mesh.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// A mesh made from another, and how far the two are apart.
struct MadeMesh {
  geometry::TriangleMesh mesh;
  double deviation = 0.0;  ///< Metres, by deviation().
};

/// The largest distance, metres, from a corner, edge midpoint or centre of a triangle of one mesh to the surface of the
/// other, both ways. Any thread; about 2 s a million triangles.
double deviation(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

/// Fewer triangles, nowhere farther from the given surface than `tolerance` (m, by deviation()). Edges are collapsed by
/// quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics", 1997) as meshoptimizer
/// does it, with less and less allowed until the measured deviation fits. Where nothing can be saved the mesh itself
/// comes back. A tolerance that is not above 0 is an error.
Expected<MadeMesh> simplify(const geometry::TriangleMesh& mesh, double tolerance);

/// The convex hull; its deviation is that of the hollows that it fills. A flat mesh is an error.
Expected<MadeMesh> convexMesh(const geometry::TriangleMesh& mesh);

/// What a solid can be checked by: simplify() or convexMesh().
Expected<CollisionProxy> makeProxy(const geometry::TriangleMesh& mesh, CollisionProxy::Kind kind, double tolerance);

/// What is odd about a mesh; the faces stay as they are for drawing and checking.
struct MeshHealth {
  std::size_t border_edges = 0;        ///< With one triangle: the surface is open.
  std::size_t non_manifold_edges = 0;  ///< With more than two triangles.
  std::size_t flipped_edges = 0;       ///< Whose two triangles face opposite ways.
  bool isClosed() const { return border_edges == 0 && non_manifold_edges == 0; }
};
MeshHealth healthOf(const geometry::TriangleMesh& mesh);

/// Turns triangles round so that neighbours face the same way and closed pieces face outwards (positive volume). Gives
/// how many were turned. Pieces with non-manifold edges are cut there; open ones follow their majority.
std::size_t orient(geometry::TriangleMesh& mesh);

/// Counts the bodies of meshes that come in whose triangles face inward (collision::facingOf()), and says so. The
/// triangles are left as they are: what is checked and felt is turned by who prepares it, and a file that is written
/// holds what was read. A mesh of any kind is taken. Any thread; about a second a million triangles.
class FacingNote {
 public:
  void look(const geometry::TriangleMesh& mesh);
  /// One sentence, or nothing where all is well.
  void tell(Diagnostics& diagnostics) const;

 private:
  std::size_t inward_ = 0;
};

}  // namespace hapticell::workcell
