// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/swept_check.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/queries/triangle_gap.h"
#include "collision/trees/dual_traversal.h"

namespace hapticell::collision {

namespace {

/// Pairs of boxes and triangles of one proof, so that it takes no longer than some queries. Half: fewer strides proven;
/// twice: more time for those that fail.
constexpr int kMostPairsSwept = 1000;

double reachAlong(const dvec3& axis, const OrientedBox& box) {
  return std::abs(glm::dot(axis, box.R[0])) * box.half.x + std::abs(glm::dot(axis, box.R[1])) * box.half.y +
         std::abs(glm::dot(axis, box.R[2])) * box.half.z;
}

Corners placed(const dmat3& R, const dvec3& p, const Corners& c) {
  return {p + R * c[0], p + R * c[1], p + R * c[2]};
}

/// All in A's frame at the beginning. A visitor of DualTraversal.
struct SweptSearch {
  const BoxTree& tree_a;
  const BoxTree& tree_b;
  const geometry::TriangleMesh& mesh_a;
  const geometry::TriangleMesh& mesh_b;
  Pose X_B0, X_B1, X_A1;
  dmat3 R_B0, R_B1, R_A1;
  double within_squared;
  double needed;
  int pairs_left = kMostPairsSwept;
  bool unproven = false;

  bool apartOn(const dvec3& direction, const Corners& a0, const Corners& b0, const Corners& a1,
               const Corners& b1) const {
    const double length = glm::length(direction);
    if (!(length > 0.0)) return false;
    const dvec3 axis = direction / length;
    return gapAlong(axis, a0, b0) >= needed && gapAlong(axis, a1, b1) >= needed;
  }

  bool trianglesStayApart(const Corners& a0, const Corners& b) {
    if (--pairs_left < 0) return false;
    const Corners b0 = placed(R_B0, X_B0.p, b), b1 = placed(R_B1, X_B1.p, b), a1 = placed(R_A1, X_A1.p, a0);
    for (const Corners* face : {&b0, &a0}) {
      const dvec3 normal = glm::cross((*face)[1] - (*face)[0], (*face)[2] - (*face)[0]);
      if (apartOn(normal, a0, b0, a1, b1) || apartOn(-normal, a0, b0, a1, b1)) return true;
    }
    const NearestPair begin = triangleDistance(a0, b0);
    if (begin.squared > within_squared) return true;
    if (apartOn(begin.p - begin.q, a0, b0, a1, b1)) return true;
    const NearestPair end = triangleDistance(a1, b1);
    return apartOn(end.p - end.q, a0, b0, a1, b1);
  }

  /// The same proof for whole boxes, on their own axes: over a plane it ends the search at once.
  bool boxesStayApart(const OrientedBox& a0, const OrientedBox& b0, const OrientedBox& b) const {
    const OrientedBox a1 = moved(R_A1, X_A1.p, a0), b1 = moved(R_B1, X_B1.p, b);
    const dvec3 apart0 = a0.center - b0.center, apart1 = a1.center - b1.center;
    for (const OrientedBox* box : {&b0, &a0}) {
      for (int i = 0; i < 3; ++i) {
        const dvec3& axis = box->R[i];
        const double shift0 = glm::dot(axis, apart0), shift1 = glm::dot(axis, apart1);
        if ((shift0 > 0.0) != (shift1 > 0.0)) continue;
        if (std::abs(shift0) - reachAlong(axis, a0) - reachAlong(axis, b0) >= needed &&
            std::abs(shift1) - reachAlong(axis, a1) - reachAlong(axis, b1) >= needed) {
          return true;
        }
      }
    }
    return false;
  }

  float limitSquared() const { return std::nextafter(static_cast<float>(within_squared), 1e30f); }
  bool isDone() const { return unproven; }
  bool passesOver(const TraversalBox& a, const TraversalBox& b) const {
    const OrientedBox box_b = tree_b.box(b.slot);
    return boxesStayApart(tree_a.box(a.slot), moved(R_B0, X_B0.p, box_b), box_b);
  }

  void leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                const LeafTransform& transform) {
    alignas(16) float ignored[9][kLeafSize];
    std::uint32_t near = proximityKernels().leafPairs(leaf_a, leaf_b, transform, limitSquared(), ignored);
    for (; near != 0 && !unproven; near &= near - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(near));
      const std::uint32_t i = leaf_a.triangle[bit % kLeafSize], j = leaf_b.triangle[bit / kLeafSize];
      unproven = !trianglesStayApart(mesh_a.corners(i), mesh_b.corners(j));
    }
  }
};

}  // namespace

bool staysApart(const MeshCollider& a, const MeshCollider& b, const SweptPair& motion, double least) {
  if (a.isEmpty() || b.isEmpty()) return true;
  if (!std::isfinite(motion.bend)) return false;
  const Pose X_A0W = motion.X_WA0.inverse();
  const Pose X_B0 = X_A0W * motion.X_WB0, X_B1 = X_A0W * motion.X_WB1, X_A1 = X_A0W * motion.X_WA1;
  const double within = motion.reach + least;
  SweptSearch search{a.tree(), b.tree(), a.mesh(),        b.mesh(),           X_B0, X_B1, X_A1, X_B0.R(),
                     X_B1.R(), X_A1.R(), within * within, least + motion.bend};
  DualTraversal<SweptSearch>(a.tree(), b.tree(), X_B0, search).run();
  return !search.unproven;
}

}  // namespace hapticell::collision
