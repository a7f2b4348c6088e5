// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "collision/trees/box_tree.h"
#include "collision/trees/collider_build.h"
#include "collision/trees/shells.h"
#include "geometry/shapes/bounds.h"
#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// A triangle mesh prepared for proximity queries: its triangles and a tree of boxes over them, in the mesh's own frame
/// M.
///
/// Immutable after build, so any thread may query it; shared, because colliders of one file serve many entities and
/// outlive edits of the document. Triangle indices in every result are those of mesh(), which is the mesh given to
/// build(); if a soup shares no vertices, identical ones (to the last bit) are kept once. census() counts unusual
/// triangles. An empty mesh is allowed; nothing is ever near it.
class MeshCollider {
 public:
  /// O(n log n); about 1.3 s for a million triangles with one thread. Indices of `mesh` are in range (else the contract
  /// is broken). Null when cancelled.
  static std::shared_ptr<const MeshCollider> build(const geometry::TriangleMesh& mesh, const ColliderBuild& how = {});

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  /// True if the mesh has no searchable triangle.
  bool isEmpty() const { return tree_.isEmpty(); }
  const TriangleCensus& census() const { return census_; }
  /// Bounds of the triangles, in M.
  const geometry::Bounds& bounds() const { return bounds_; }
  /// A sphere around all triangles, in M: p_MS and its radius (m).
  const dvec3& center() const { return center_; }
  double radius() const { return radius_; }
  /// Whether every connected piece encloses a volume.
  bool isClosed() const { return shells_.allClosed(); }
  /// Whether the point p_MQ lies inside a closed piece of the mesh. Any thread.
  bool contains(const dvec3& p_MQ) const;

  /// Bytes held, the mesh included.
  std::size_t memory() const;

  const BoxTree& tree() const { return tree_; }
  const Shells& shells() const { return shells_; }

 private:
  MeshCollider() = default;
  void measure(const std::vector<std::uint32_t>& triangles);

  geometry::TriangleMesh mesh_;
  TriangleCensus census_;
  geometry::Bounds bounds_;
  dvec3 center_{0.0};
  double radius_ = 0.0;
  BoxTree tree_;
  Shells shells_;
};

}  // namespace hapticell::collision
