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
    if (demand.enough >= (1.0 - 1e-9) * demand.limit) eager_ = 1;
  }
}

void NearestSearch::begin(StepPairs* list) {
  list_ = list;
  slack_ = list == nullptr ? 0.0 : list->begin();
  if (slack_ == 0.0) list_ = nullptr;
  if (list_ == nullptr || !found_) return;
  // What was found before is a bound, but without the slack.
  prune_squared_ = static_cast<float>(demand_.limit * demand_.limit);
  pruneFrom(std::sqrt(best_.squared));
}

void NearestSearch::run(const TriangleIndices& warm, StepPairs* list) {
  begin(list);
  tryPair(warm);
  search();
}

void NearestSearch::run(StepPairs* list) {
  begin(list);
  search();
}

void NearestSearch::search() {
  if (!done_) {
    DualTraversal<NearestSearch> traversal(a_.tree(), b_.tree(), X_AB_, *this);
    traversal.run();
    flush();
  }
  if (list_ == nullptr) return;
  // Less than the float by which the trees were searched.
  constexpr double kRounded = 1.0 - 1e-6;
  if (done_ || !found_)
    stopCollecting();
  else
    list_->finish(kRounded * std::sqrt(static_cast<double>(prune_squared_)));
}

void NearestSearch::runListed(const TriangleIndices& warm, StepPairs& list) {
  tryPair(warm);
  const double moved = list.movedSince(X_AB_);
  double R[9];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) R[3 * i + k] = R_AB_[k][i];
  }
  const double t[3] = {p_AB_.x, p_AB_.y, p_AB_.z};
  const std::span<const StepPairs::Pair> pairs = list.pairs();
  ExactPairs placed;
  for (std::size_t k = 0; k < pairs.size() && !done_; k += kTreeWidth) {
    const double least = (1.0 - 1e-6) * static_cast<double>(pairs[k].least) - moved;  // It is a float.
    if (least > 0.0 && least * least >= best_.squared) return;
    const int count = static_cast<int>(std::min<std::size_t>(kTreeWidth, pairs.size() - k));
    proximityKernels().placePairs(list.corners(k / kTreeWidth, a_.mesh(), b_.mesh()), R, t, placed);
    if (!mayImprove(placed, count)) continue;
    TriangleIndices batch[kTreeWidth];
    for (int lane = 0; lane < count; ++lane) batch[lane] = pairs[k + static_cast<std::size_t>(lane)].pair;
    measure(placed, batch, count);
  }
}

void NearestSearch::stopCollecting() {
  list_->giveUp();
  list_ = nullptr;
  slack_ = 0.0;
  if (found_) pruneFrom(std::sqrt(best_.squared));
}

/// Of the measured pairs what is near enough.
void NearestSearch::collect(int count) {
  for (int lane = 0; lane < count; ++lane) {
    const float squared = distances_.squared[lane] - distances_.doubt[lane];
    if (squared > prune_squared_) continue;
    if (list_->add(packed_pair_[lane], std::sqrt(std::max(squared, 0.0F)))) continue;
    return stopCollecting();
  }
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
  prune += slack_;
  prune_squared_ = std::min(prune_squared_, static_cast<float>(prune * prune));
}

void NearestSearch::tryPair(const TriangleIndices& pair) {
  if (!improveTriangleDistance(cornersA(pair.a), cornersB(pair.b), best_)) return;
  pair_ = pair;
  found_ = true;
  aim();
  const double distance = std::sqrt(best_.squared);
  done_ = distance <= demand_.enough;
  pruneFrom(distance);
}

void NearestSearch::aim() {
  const dvec3 apart = best_.q - best_.p;
  const double length = glm::length(apart);
  if (length == 0.0) return;
  const dvec3 line_a = apart / length, line_b = glm::transpose(R_AB_) * line_a;
  for (int i = 0; i < 3; ++i) {
    line_[i] = line_a[i];
    line_a_[i] = static_cast<float>(line_a[i]);
    line_b_[i] = static_cast<float>(line_b[i]);
  }
}

void NearestSearch::leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                             const LeafTransform& transform) {
  alignas(16) float corners_b[9][kLeafSize];
  std::uint32_t near = proximityKernels().leafPairs(leaf_a, leaf_b, transform, prune_squared_, corners_b);
  for (; near != 0; near &= near - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(near));
    const std::uint32_t i = bit % kLeafSize, j = bit / kLeafSize;
    const TriangleIndices pair{leaf_a.triangle[i], leaf_b.triangle[j]};
    if (pair == pair_ && found_ && list_ == nullptr) continue;
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
  // The first bound is worth a kernel of its own. Where any near pair will do the first ones probably are; twice as
  // many each time that they were not.
  if (packed_ >= eager_) {
    flush();
    eager_ *= 2;
  } else if (best_.squared == std::numeric_limits<double>::infinity()) {
    flush();
  }
}

void NearestSearch::flush() {
  if (packed_ == 0) return;
  const int count = packed_;
  packed_ = 0;
  proximityKernels().packedDistances(pack_, count, distances_);
  if (list_ != nullptr) collect(count);
  const auto isCandidate = [&](int lane) {
    return distances_.squared[lane] - distances_.doubt[lane] < static_cast<float>(best_.squared);
  };
  int nearest = 0;
  std::uint32_t lanes = 0;
  for (int lane = 0; lane < count; ++lane) {
    if (isCandidate(lane)) lanes |= 1u << lane;
    if (distances_.squared[lane] < distances_.squared[nearest]) nearest = lane;
  }
  if (lanes == 0) return;
  if (distances_.squared[nearest] + distances_.doubt[nearest] < static_cast<float>(best_.squared)) {
    tryPair(packed_pair_[nearest]);
    if (done_) return;
    lanes &= ~(1u << nearest);
    for (int lane = 0; lane < count; ++lane) {
      if (!isCandidate(lane)) lanes &= ~(1u << lane);
    }
  }
  if (lanes != 0) tryTies(lanes);
}

void NearestSearch::tryTies(std::uint32_t lanes) {
  TriangleIndices batch[kTreeWidth];
  int count = 0;
  for (; lanes != 0 && !done_; lanes &= lanes - 1) {
    batch[count++] = packed_pair_[std::countr_zero(lanes)];
    if (count < kTreeWidth && (lanes & (lanes - 1)) != 0) continue;
    tryExactly(batch, count);
    count = 0;
  }
}

void NearestSearch::tryExactly(const TriangleIndices* tried, int count) {
  if (count == 1) return tryPair(tried[0]);
  ExactPairs pairs;
  for (int lane = 0; lane < kTreeWidth; ++lane) {
    const TriangleIndices& pair = tried[std::min(lane, count - 1)];
    const Corners first = cornersA(pair.a), second = cornersB(pair.b);
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) {
        pairs.first[3 * c + static_cast<std::size_t>(i)][lane] = first[c][i];
        pairs.second[3 * c + static_cast<std::size_t>(i)][lane] = second[c][i];
      }
    }
  }
  if (mayImprove(pairs, count)) measure(pairs, tried, count);
}

/// Pairs that the nearest points' line already keeps apart, as those do that share the nearest corner or edge, cannot.
bool NearestSearch::mayImprove(const ExactPairs& pairs, int count) const {
  double gaps[kTreeWidth];
  proximityKernels().exactGaps(pairs, line_, gaps);
  const double bound = std::sqrt(best_.squared) - (found_ ? kNegligible : 0.0);
  return *std::min_element(gaps, gaps + count) < bound;
}

void NearestSearch::measure(const ExactPairs& pairs, const TriangleIndices* tried, int count) {
  double squared[kTreeWidth];
  proximityKernels().exactDistances(pairs, squared);
  const int nearest = static_cast<int>(std::min_element(squared, squared + count) - squared);
  if (squared[nearest] < best_.squared * (1.0 - kTieShare)) tryPair(tried[nearest]);
}

}  // namespace hapticell::collision
