// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/system/error.h"
#include "geometry/shapes/triangle_mesh.h"
#include "workcell/entity/entity.h"

namespace hapticell::workcell {

/// A mesh made from another one, and the distance between the two.
struct MadeMesh {
  geometry::TriangleMesh mesh;
  double deviation = 0.0;  ///< Metres, by deviation().
};

/// The largest distance, metres, from a corner, edge midpoint or centre of a triangle of one mesh to the surface of the
/// other, both ways. Any thread; about 2 s per million triangles.
double deviation(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

/// Reduces the triangles; the result is nowhere farther from the given surface than `tolerance` (m, by deviation()).
/// Edges are collapsed by quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics",
/// 1997) with meshoptimizer, with smaller and smaller limits until the measured deviation fits. Returns the mesh itself
/// if nothing can be reduced. Error: a tolerance that is not above 0.
Expected<MadeMesh> simplify(const geometry::TriangleMesh& mesh, double tolerance);

/// The convex hull; its deviation is the depth of the hollows that it fills. Error: a flat mesh.
Expected<MadeMesh> convexMesh(const geometry::TriangleMesh& mesh);

/// Makes a collision shape for a solid: by simplify() or convexMesh().
Expected<CollisionProxy> makeProxy(const geometry::TriangleMesh& mesh, CollisionProxy::Kind kind, double tolerance);

/// Defects of a mesh; its faces are drawn and checked as they are.
struct MeshHealth {
  std::size_t border_edges = 0;        ///< With one triangle: the surface is open.
  std::size_t non_manifold_edges = 0;  ///< With more than two triangles.
  std::size_t flipped_edges = 0;       ///< The two triangles face opposite ways.
  bool isClosed() const { return border_edges == 0 && non_manifold_edges == 0; }
};
MeshHealth healthOf(const geometry::TriangleMesh& mesh);

/// Reverses triangles so that neighbours face the same way and closed pieces face outwards (positive volume). Returns
/// the number of reversed triangles. Pieces are split at non-manifold edges; open pieces follow their majority.
std::size_t orient(geometry::TriangleMesh& mesh);

/// Counts the bodies of imported meshes whose triangles face inwards (collision::facingOf()), and reports them. Does
/// not change the triangles: the preparation for checks and forces turns them, and exports contain what was read.
/// Accepts any mesh. Any thread; about a second per million triangles.
class FacingNote {
 public:
  void look(const geometry::TriangleMesh& mesh);
  /// One sentence, or nothing if all bodies face outwards.
  void tell(Diagnostics& diagnostics) const;

 private:
  std::size_t inward_ = 0;
};

}  // namespace hapticell::workcell
