// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Some triangles of a mesh and the vertices that they use, each once.
struct Patch {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> vertices;
};

/// A welded mesh with its triangles' normals and neighbours, for cutting its surface into patches.
///
/// Two triangles are neighbours only across an edge that exactly these two use in opposite directions; every other
/// edge (open, non-manifold, flipped) is a border.
class SurfaceGraph {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// Welds a copy of `mesh`; surfaces nearer than `tolerance` (m) count as touching, so they do not obstruct each
  /// other.
  SurfaceGraph(const geometry::TriangleMesh& mesh, double tolerance);

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  double tolerance() const { return tolerance_; }
  /// Diagonal of the bounds, metres.
  double size() const { return size_; }
  const dvec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  double area(std::uint32_t triangle) const { return areas_[triangle]; }
  /// Across the edge from corner k to corner k+1; kNone at a border.
  std::uint32_t neighbour(std::uint32_t triangle, int k) const {
    return neighbours_[triangle][static_cast<std::size_t>(k)];
  }
  /// Whether the neighbour across edge k lies behind this triangle's plane (or in it), within the tolerance.
  bool isConvexAcross(std::uint32_t triangle, int k) const;
  /// Index of the triangle in the given mesh.
  std::uint32_t originalTriangle(std::uint32_t triangle) const { return original_[triangle]; }

  /// Whether all vertices lie in the plane of the first triangle.
  bool isFlat(const Patch& patch) const;
  /// Unit normals of the triangles beyond the patch's sharp convex borders, equal ones once.
  std::vector<dvec3> normalsBeyond(const Patch& patch) const;
  Patch patchOf(std::vector<std::uint32_t> triangles) const;
  /// Triangles connected by shared vertices.
  std::vector<std::vector<std::uint32_t>> components() const;

 private:
  void dropDegenerate(const geometry::TriangleMesh& mesh);
  void connect();

  geometry::TriangleMesh mesh_;
  double tolerance_;
  double size_ = 0.0;
  std::vector<dvec3> normals_;
  std::vector<double> areas_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<std::uint32_t> original_;
};

/// Divides all triangles into patches whose convex hull contains no other part of the surface deeper than the
/// tolerance. `collider` is that of graph.mesh().
std::vector<Patch> convexPatches(const SurfaceGraph& graph, const MeshCollider& collider);

}  // namespace hapticell::collision
