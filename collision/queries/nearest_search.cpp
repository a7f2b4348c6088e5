// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/nearest_search.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hapticell::collision {

namespace {

/// What cannot improve the distance by more than this (m) is passed over: ties are common on CAD parts. Half of the
/// 1e-9 that answers are good to (DistanceOracle). Half: ties are searched; twice: at that limit.
constexpr double kNegligible = 5e-10;
/// The same for pairs that were measured in double, as a share of the square: a thousand times its rounding. Half:
/// still; twice: 1e-12 of the distance.
constexpr double kTieShare = 1e-12;

}  // namespace

NearestSearch::NearestSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, const SearchDemand& demand)
    : a_(a), b_(b), R_AB_(X_AB.R()), p_AB_(X_AB.p), X_AB_(X_AB), demand_(demand) {
  if (demand.limit < std::numeric_limits<double>::infinity()) {
    best_.squared = demand.limit * demand.limit;
    prune_squared_ = static_cast<float>(best_.squared);
  }
}

void NearestSearch::run(const TriangleIndices& warm) {
  tryPair(warm);
  if (done_) return;
  DualTraversal<NearestSearch> traversal(a_.tree(), b_.tree(), X_AB_, *this);
  traversal.run();
  flush();
}

Corners NearestSearch::cornersA(std::uint32_t triangle) const {
  return a_.mesh().corners(triangle);
}

Corners NearestSearch::cornersB(std::uint32_t triangle) const {
  const geometry::TriangleMesh& mesh = b_.mesh();
  return {p_AB_ + R_AB_ * mesh.corner(triangle, 0), p_AB_ + R_AB_ * mesh.corner(triangle, 1),
          p_AB_ + R_AB_ * mesh.corner(triangle, 2)};
}

void NearestSearch::pruneFrom(double distance) {
  double prune = std::max(distance - kNegligible, 0.0);
  if (prune > demand_.exact_within) prune = std::max(demand_.exact_within, prune / (1.0 + demand_.tolerance));
  prune_squared_ = static_cast<float>(prune * prune);
}

void NearestSearch::tryPair(const TriangleIndices& pair) {
  if (!improveTriangleDistance(cornersA(pair.a), cornersB(pair.b), best_)) return;
  pair_ = pair;
  found_ = true;
  const double distance = std::sqrt(best_.squared);
  done_ = distance <= demand_.enough;
  pruneFrom(distance);
}

void NearestSearch::leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                             const LeafTransform& transform) {
  alignas(16) float corners_b[9][kLeafSize];
  std::uint32_t near = proximityKernels().leafPairs(leaf_a, leaf_b, transform, prune_squared_, corners_b);
  for (; near != 0; near &= near - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(near));
    const std::uint32_t i = bit % kLeafSize, j = bit / kLeafSize;
    const TriangleIndices pair{leaf_a.triangle[i], leaf_b.triangle[j]};
    if (pair == pair_ && found_) continue;
    for (int k = 0; k < 9; ++k) {
      pack_.first[k][packed_] = leaf_a.corner[k][i];
      pack_.second[k][packed_] = corners_b[k][j];
    }
    packed_pair_[packed_++] = pair;
    if (packed_ == kPackSize) {
      flush();
      if (done_) return;
    }
  }
  // The first bound is worth a kernel of its own.
  if (best_.squared == std::numeric_limits<double>::infinity()) flush();
}

void NearestSearch::flush() {
  if (packed_ == 0) return;
  const int count = packed_;
  packed_ = 0;
  proximityKernels().packedDistances(pack_, distances_);
  const auto mayImprove = [&](int lane) {
    return distances_.squared[lane] - distances_.doubt[lane] < static_cast<float>(best_.squared);
  };
  int nearest = 0;
  std::uint32_t lanes = 0;
  for (int lane = 0; lane < count; ++lane) {
    if (mayImprove(lane)) lanes |= 1u << lane;
    if (distances_.squared[lane] < distances_.squared[nearest]) nearest = lane;
  }
  if (lanes == 0) return;
  if (distances_.squared[nearest] + distances_.doubt[nearest] < static_cast<float>(best_.squared)) {
    tryPair(packed_pair_[nearest]);
    if (done_) return;
    lanes &= ~(1u << nearest);
    for (int lane = 0; lane < count; ++lane) {
      if (!mayImprove(lane)) lanes &= ~(1u << lane);
    }
  }
  if (lanes != 0) tryTies(lanes);
}

void NearestSearch::tryTies(std::uint32_t lanes) {
  int batch[kTreeWidth];
  int count = 0;
  for (; lanes != 0 && !done_; lanes &= lanes - 1) {
    batch[count++] = std::countr_zero(lanes);
    if (count < kTreeWidth && (lanes & (lanes - 1)) != 0) continue;
    tryExactly(batch, count);
    count = 0;
  }
}

void NearestSearch::tryExactly(const int* lanes, int count) {
  if (count == 1) return tryPair(packed_pair_[lanes[0]]);
  ExactPairs pairs;
  for (int lane = 0; lane < kTreeWidth; ++lane) {
    const TriangleIndices& pair = packed_pair_[lanes[std::min(lane, count - 1)]];
    const Corners first = cornersA(pair.a), second = cornersB(pair.b);
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) {
        pairs.first[3 * c + static_cast<std::size_t>(i)][lane] = first[c][i];
        pairs.second[3 * c + static_cast<std::size_t>(i)][lane] = second[c][i];
      }
    }
  }
  double squared[kTreeWidth];
  proximityKernels().exactDistances(pairs, squared);
  const int nearest = static_cast<int>(std::min_element(squared, squared + count) - squared);
  if (squared[nearest] < best_.squared * (1.0 - kTieShare)) tryPair(packed_pair_[lanes[nearest]]);
}

}  // namespace hapticell::collision
