// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/sweep_search.h"

#include <bit>

namespace hapticell::collision {

namespace {

/// More than the rounding of a number to float, so that limits become no smaller.
constexpr double kOutward = 1.0 + 1e-6;

float outward(double x) {
  return static_cast<float>(kOutward * x);
}

}  // namespace

SweepSearch::SweepSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, const Sweep& sweep)
    : a_(a),
      b_(b),
      R_AB_(X_AB.R()),
      p_AB_(X_AB.p),
      X_AB_(X_AB),
      margin_(sweep.margin),
      reach_(sweep.margin + glm::length(sweep.d_A)),
      pair_(),
      effort_(sweep.effort) {
  const dvec3 d_B = glm::transpose(R_AB_) * sweep.d_A;
  for (int i = 0; i < 3; ++i) {
    sweep_a_[i] = static_cast<float>(sweep.d_A[i]);
    sweep_b_[i] = static_cast<float>(d_B[i]);
  }
  // What the sweep is off in float: below 1e-7 of the reach.
  const double limit = sweep.margin + 1e-6 * reach_;
  limit_squared_ = outward(limit * limit);
  reach_squared_ = outward(reach_ * reach_);
}

bool SweepSearch::isNear(const TriangleIndices& pair, double reach) const {
  NearestPair nearest;
  nearest.squared = reach * reach;
  const geometry::TriangleMesh& mesh = b_.mesh();
  const Corners corners_b{p_AB_ + R_AB_ * mesh.corner(pair.b, 0), p_AB_ + R_AB_ * mesh.corner(pair.b, 1),
                          p_AB_ + R_AB_ * mesh.corner(pair.b, 2)};
  return improveTriangleDistance(a_.mesh().corners(pair.a), corners_b, nearest);
}

bool SweepSearch::run(TriangleIndices& warm, bool& is_near) {
  if (is_near && isNear(warm, margin_)) return true;
  DualTraversal<SweepSearch> traversal(a_.tree(), b_.tree(), X_AB_, *this);
  traversal.run();
  is_near = found_ && effort_ >= 0;
  if (is_near) warm = pair_;
  return found_;
}

/// Not by the plane of either, nor along the line between their middles, nor beside the sweep apart: where also the
/// least distance allows it, they are said to meet.
void SweepSearch::leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                           const LeafTransform& transform) {
  alignas(16) float corners_b[9][kLeafSize];
  const std::uint32_t near =
      proximityKernels().sweptLeafPairs(leaf_a, leaf_b, transform, limit_squared_, sweep_a_, corners_b);
  if (near == 0) return;
  PackedPairs packed;
  TriangleIndices pairs[kPackSize];
  int count = 0;
  for (std::uint32_t left = near; left != 0; left &= left - 1, ++count) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
    const std::uint32_t i = bit % kLeafSize, j = bit / kLeafSize;
    pairs[count] = {leaf_a.triangle[i], leaf_b.triangle[j]};
    for (int k = 0; k < 9; ++k) {
      packed.first[k][count] = leaf_a.corner[k][i];
      packed.second[k][count] = corners_b[k][j];
    }
  }
  for (int lane = count; lane < kPackSize; ++lane) {
    for (int k = 0; k < 9; ++k) packed.first[k][lane] = packed.second[k][lane] = 0.0F;
  }
  PackedDistances distances;
  proximityKernels().packedDistances(packed, count, distances);
  for (int lane = 0; lane < count && !found_; ++lane) {
    if (distances.squared[lane] - distances.doubt[lane] > reach_squared_) continue;
    pair_ = pairs[lane];
    found_ = isNear(pair_, reach_);
  }
}

}  // namespace hapticell::collision
