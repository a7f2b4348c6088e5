// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/sweep_search.h"

#include <bit>
#include <cmath>

namespace hapticell::collision {

namespace {

/// More than the rounding of a number to float, so that limits become no smaller.
constexpr double kOutward = 1.0 + 1e-6;

float outward(double x) {
  return static_cast<float>(kOutward * x);
}

}  // namespace

SweepSearch::SweepSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_WA, const Pose& X_WB,
                         const Demand& demand)
    : a_(a),
      b_(b),
      X_AB_(X_WA.inverse() * X_WB),
      R_AB_(X_AB_.R()),
      p_AB_(X_AB_.p),
      turn_of_a_(glm::length(demand.a.turn_W)),
      turn_of_b_(glm::length(demand.b.turn_W)),
      margin_(demand.margin),
      pair_(),
      effort_(demand.effort) {
  const dmat3 R_AW = glm::transpose(X_WA.R()), R_BA = glm::transpose(R_AB_);
  const dvec3 d_A = R_AW * (demand.a.d_W - demand.b.d_W), turn_a_A = R_AW * demand.a.turn_W,
              turn_b_A = R_AW * demand.b.turn_W;
  of_a_ = {d_A, turn_a_A, a.center(), turn_b_A, p_AB_ + R_AB_ * b.center()};
  of_b_ = {-(R_BA * d_A), R_BA * turn_b_A, b.center(), R_BA * turn_a_A, R_BA * (a.center() - p_AB_)};
  const double sweep = glm::length(d_A) + turn_of_a_ * a.radius() + turn_of_b_ * b.radius();
  reach_squared_ = outward((margin_ + sweep) * (margin_ + sweep));
}

/// `other` is seen in the opened box's frame.
BoxSweep SweepSearch::sweepOf(bool opened_a, const BoxNode& opened, const TraversalBox& other) const {
  const Field& field = opened_a ? of_a_ : of_b_;
  const double turn_of_opened = opened_a ? turn_of_a_ : turn_of_b_, turn_of_other = opened_a ? turn_of_b_ : turn_of_a_;
  const dvec3 at = field.at({opened.origin[0], opened.origin[1], opened.origin[2]}, other.seen_center);
  BoxSweep sweep;
  for (int i = 0; i < 3; ++i) {
    sweep.at[i] = static_cast<float>(at[i]);
    sweep.turn[i] = static_cast<float>(field.turn_self[i]);
  }
  sweep.margin = outward(margin_ + turn_of_other * std::sqrt(double{other.size}));
  sweep.turn_size = outward(turn_of_opened);
  return sweep;
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
void SweepSearch::leafPair(const TraversalBox& a, const TraversalBox& b, const LeafBlock& leaf_a,
                           const LeafBlock& leaf_b, const LeafTransform& transform) {
  alignas(16) float corners_b[9][kLeafSize];
  const dvec3 sweep_A = of_a_.at(a.center, p_AB_ + R_AB_ * b.center);
  const double turned = turn_of_a_ * std::sqrt(double{a.size}) + turn_of_b_ * std::sqrt(double{b.size});
  const double limit = margin_ + turned, reach = limit + glm::length(sweep_A);
  const float sweep[3] = {static_cast<float>(sweep_A.x), static_cast<float>(sweep_A.y), static_cast<float>(sweep_A.z)};
  const std::uint32_t near =
      proximityKernels().sweptLeafPairs(leaf_a, leaf_b, transform, outward(limit * limit), sweep, corners_b);
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
  const float reach_squared = outward(reach * reach);
  PackedDistances distances;
  proximityKernels().packedDistances(packed, count, distances);
  for (int lane = 0; lane < count && !found_; ++lane) {
    if (distances.squared[lane] - distances.doubt[lane] > reach_squared) continue;
    pair_ = pairs[lane];
    found_ = isNear(pair_, reach);
  }
}

}  // namespace hapticell::collision
