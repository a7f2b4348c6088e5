// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// The point of a mesh nearest to a given one, in the mesh's frame M.
struct NearestPoint {
  bool found = false;                                         ///< False when nothing is nearer than the limit.
  double distance = std::numeric_limits<double>::infinity();  ///< Metres, to the surface (also from inside a solid).
  dvec3 p_MQ{0.0};
  std::uint32_t triangle = 0;
};

/// Nearest surface point to p_MP, nearer than `limit` (m). Any thread; does not allocate.
NearestPoint nearestPoint(const MeshCollider& mesh, const dvec3& p_MP,
                          double limit = std::numeric_limits<double>::infinity());

/// A crossing of a ray with a mesh, in the mesh's frame M.
struct RayHit {
  bool found = false;
  double along = std::numeric_limits<double>::infinity();  ///< In multiples of the direction's length.
  dvec3 p_MQ{0.0};
  std::uint32_t triangle = 0;
};

/// First crossing of the ray from p_MO along direction_M with the surface, from either side. For picking; any thread.
RayHit castRay(const MeshCollider& mesh, const dvec3& p_MO, const dvec3& direction_M);

/// Appends to `found` every triangle whose distance to the point p_MP is `radius` (m) or less, each once, in no order.
void trianglesWithin(const MeshCollider& mesh, const dvec3& p_MP, double radius, std::vector<std::uint32_t>& found);

/// The same for a box in M.
void trianglesWithin(const MeshCollider& mesh, const geometry::Bounds& box_M, double radius,
                     std::vector<std::uint32_t>& found);

/// Appends every triangle of B whose distance to the mesh A (placed by X_BA) is `radius` (m) or less.
void trianglesWithin(const MeshCollider& b, const MeshCollider& a, const Pose& X_BA, double radius,
                     std::vector<std::uint32_t>& found_in_b);

/// Two neighbouring triangles, with their nearest points in A's frame.
struct TrianglePair {
  std::uint32_t triangle_a = 0;
  std::uint32_t triangle_b = 0;
  double distance = 0.0;  ///< Metres; 0 when they intersect.
  dvec3 p_AP{0.0};        ///< On A's triangle.
  dvec3 p_AQ{0.0};        ///< On B's triangle.
};

/// Appends every pair of triangles of A and B (placed by X_AB) whose distance is `radius` (m) or less, until `found`
/// holds `maximum` pairs. Returns false when it stopped there.
bool trianglePairsWithin(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius,
                         std::vector<TrianglePair>& found, std::size_t maximum = 1u << 20);

/// A mesh whose triangles have labels; many triangles share one label (that of a convex piece). All vectors outlive the
/// call.
struct LabelledMesh {
  const MeshCollider& mesh;
  const std::vector<std::uint32_t>& label_of;  ///< Per triangle of the mesh.
  std::uint32_t labels = 0;                    ///< One more than the largest.
};

struct LabelPair {
  std::uint32_t label_a = 0;
  std::uint32_t label_b = 0;
};

/// Limits after which a search gives up; the same on every machine.
struct SearchBudget {
  std::size_t pairs = 0;  ///< Pairs found.
  std::size_t tests = 0;  ///< Triangle pairs examined.
};

/// Every pair of labels of A and B (placed by X_AB) of which two triangles are at most `radius` (m) apart, each once.
/// Returns false when the budget ended before the search did; `found` then holds some of them. The tests that were used
/// are subtracted from the budget.
bool labelPairsWithin(const LabelledMesh& a, const LabelledMesh& b, const Pose& X_AB, double radius,
                      SearchBudget& budget, std::vector<LabelPair>& found);

}  // namespace hapticell::collision
