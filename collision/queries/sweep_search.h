// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "collision/queries/part_sweep.h"
#include "collision/queries/triangle_pairs.h"
#include "collision/trees/dual_traversal.h"
#include "collision/trees/mesh_collider.h"
#include "collision/trees/triangle_distance.h"

namespace hapticell::collision {

/// The search for triangles of two meshes that may come nearer than a margin while both move by sweeps, all in A's
/// frame: the searched space of a long motion grows along the motion only, not to its sides. Each pair of boxes has the
/// sweep that their middles see, and the rotation of a box about its own middle shrinks with the box. A visitor of
/// DualTraversal. One object per query, on the stack; does not allocate.
class SweepSearch {
 public:
  struct Demand {
    PartSweep a, b;
    double margin = 0.0;                           ///< m
    int effort = std::numeric_limits<int>::max();  ///< Boxes that are opened at most; then they may meet.
  };

  SweepSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_WA, const Pose& X_WB, const Demand& demand);

  /// Whether there are such triangles: false is proven. Tries the pair `warm` first if `is_near` says that it probably
  /// is; leaves there what it found, and whether it found some.
  bool run(TriangleIndices& warm, bool& is_near);

  // For DualTraversal.
  float limitSquared() const { return std::numeric_limits<float>::infinity(); }
  float reachSquared() const { return reach_squared_; }
  bool isDone() {
    found_ |= --effort_ < 0;
    return found_;
  }
  BoxSweep sweepOf(bool opened_a, const BoxNode& opened, const TraversalBox& other) const;
  void leafPair(const TraversalBox& a, const TraversalBox& b, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                const LeafTransform& transform);

 private:
  /// The sweep of one part against the other, in the frame of one of them: d + turn_self x (p - self), less
  /// turn_other x (q - other), where p is of the part whose frame it is.
  struct Field {
    dvec3 d{0.0}, turn_self{0.0}, self{0.0}, turn_other{0.0}, other{0.0};

    dvec3 at(const dvec3& p, const dvec3& q) const {
      return d + glm::cross(turn_self, p - self) - glm::cross(turn_other, q - other);
    }
  };

  bool isNear(const TriangleIndices& pair, double reach) const;

  const MeshCollider& a_;
  const MeshCollider& b_;
  Pose X_AB_;
  dmat3 R_AB_;
  dvec3 p_AB_;
  Field of_a_, of_b_;             ///< In A's frame, and in B's.
  double turn_of_a_, turn_of_b_;  ///< rad
  double margin_;                 ///< m
  float reach_squared_;           ///< With all that the sweeps are.
  TriangleIndices pair_;
  int effort_;
  bool found_ = false;
};

}  // namespace hapticell::collision
