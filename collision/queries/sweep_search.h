// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "collision/queries/triangle_pairs.h"
#include "collision/trees/dual_traversal.h"
#include "collision/trees/mesh_collider.h"
#include "collision/trees/triangle_distance.h"

namespace hapticell::collision {

/// A straight motion of A against B, forward and backward from the present poses, and the distance of interest.
struct Sweep {
  dvec3 d_A{0.0};                                ///< A moves by any share from -1 to 1 of it, m, in A's frame.
  double margin = 0.0;                           ///< m.
  int effort = std::numeric_limits<int>::max();  ///< Boxes that are opened at most; then they may meet.
};

/// The search for triangles of two meshes that may come nearer than a margin during a sweep, all in A's frame: the
/// searched space of a long motion grows along the motion only, not to its sides. A visitor of DualTraversal. One
/// object per query, on the stack; does not allocate.
class SweepSearch {
 public:
  SweepSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, const Sweep& sweep);

  /// Whether there are such triangles: false is proven. Tries the pair `warm` first if `is_near` says that it probably
  /// is; leaves there what it found, and whether it found some.
  bool run(TriangleIndices& warm, bool& is_near);

  // For DualTraversal.
  float limitSquared() const { return limit_squared_; }
  float reachSquared() const { return reach_squared_; }
  bool isDone() {
    found_ |= --effort_ < 0;
    return found_;
  }
  const float* sweep(bool in_a) const { return in_a ? sweep_a_ : sweep_b_; }
  void leafPair(const TraversalBox& a, const TraversalBox& b, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                const LeafTransform& transform);

 private:
  bool isNear(const TriangleIndices& pair, double reach) const;

  const MeshCollider& a_;
  const MeshCollider& b_;
  dmat3 R_AB_;
  dvec3 p_AB_;
  Pose X_AB_;
  float sweep_a_[3], sweep_b_[3];  ///< In each mesh's frame.
  double margin_, reach_;          ///< m; the second with the sweep's length.
  float limit_squared_, reach_squared_;
  TriangleIndices pair_;
  int effort_;
  bool found_ = false;
};

}  // namespace hapticell::collision
