// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "collision/box_tree.h"
#include "collision/distance_result.h"
#include "collision/shells.h"
#include "geometry/bounds.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::collision {

/// A triangle mesh prepared for proximity queries: its triangles and a tree of boxes over them, in the mesh's own frame
/// M.
///
/// Immutable after build, so any thread may query it; shared, because colliders of one file serve many entities and
/// outlive edits of the document. Triangle indices in every result are those of mesh(), which is the mesh given to
/// build(), unchanged: degenerate triangles count as the segment or point that they are. An empty mesh is allowed;
/// nothing is ever near it.
class MeshCollider {
 public:
  /// Takes O(n log n); about 1 s for a million triangles. Indices of `mesh` are in range and coordinates finite (else
  /// the contract is broken).
  static std::shared_ptr<const MeshCollider> build(const geometry::TriangleMesh& mesh);

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  bool isEmpty() const { return mesh_.triangles.empty(); }
  /// Of the triangles, in M.
  const geometry::Bounds& bounds() const { return bounds_; }
  /// A sphere about all triangles, in M: p_MS and its radius (m).
  const dvec3& center() const { return center_; }
  double radius() const { return radius_; }
  /// Every connected piece encloses a volume.
  bool isClosed() const { return shells_.allClosed(); }
  /// The point p_MQ lies inside a closed piece of the mesh. Any thread.
  bool contains(const dvec3& p_MQ) const;

  /// Bytes held, the mesh included.
  std::size_t memory() const;

  const BoxTree& tree() const { return tree_; }
  const Shells& shells() const { return shells_; }

 private:
  MeshCollider() = default;

  geometry::TriangleMesh mesh_;
  geometry::Bounds bounds_;
  dvec3 center_{0.0};
  double radius_ = 0.0;
  BoxTree tree_;
  Shells shells_;
};

}  // namespace hapticell::collision
