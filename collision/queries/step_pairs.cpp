// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/step_pairs.h"

#include <algorithm>

namespace hapticell::collision {

namespace {

/// Steps that a list is to last: two of each for every one (the pair that was nearest goes away, another one comes).
/// Half: searched twice as often; twice: twice as many pairs in it.
constexpr double kSteps = 12.0;
/// In steps: a narrower list is used up before it is worth its collecting. Half: lists for one step; twice: none where
/// triangles are small.
constexpr double kFewestSteps = 4.0;
/// m: wider ones serve no step of a hand. Half: fast hands search; twice: long lists of what is far.
constexpr double kWidest = 0.01;
/// By which the width shrinks when there were too many pairs, and grows with each search without a list, and after one
/// of under a quarter. Half or twice: more failed tries, or fewer lists.
constexpr double kAfterCrowded = 0.5, kWithTime = 1.01, kAfterRoomy = 1.3;

}  // namespace

double StepPairs::come(const Pose& X_AB) {
  step_ = has_come_ ? motionBound(lever_, X_ABNow_, X_AB) : kWidest;
  has_come_ = true;
  X_ABNow_ = X_AB;
  return reachAt(X_AB);
}

double StepPairs::begin() {
  radius_ = -1.0;
  const double wanted = std::min(kSteps * step_, most_);
  if (wanted < kFewestSteps * step_ || wanted == 0.0) {
    most_ = std::min(kWidest, most_ * kWithTime);
    return 0.0;
  }
  pairs_.clear();
  pairs_.reserve(kMostOnTheWay);
  corners_.clear();
  corners_.reserve(kMost / kTreeWidth);
  return wanted;
}

bool StepPairs::add(const TriangleIndices& pair, float least) {
  if (pairs_.size() == kMostOnTheWay) return false;
  pairs_.push_back({pair, least});
  return true;
}

void StepPairs::finish(double radius) {
  // The search narrowed as it went.
  std::erase_if(pairs_, [&](const Pair& one) { return static_cast<double>(one.least) > radius; });
  if (pairs_.size() > kMost) return giveUp();
  if (pairs_.size() < kMost / 4) most_ = std::min(kWidest, most_ * kAfterRoomy);
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) { return a.least < b.least; });
  X_AB_ = X_ABNow_;
  radius_ = radius;
}

const ExactPairs& StepPairs::corners(std::size_t batch, const geometry::TriangleMesh& a,
                                     const geometry::TriangleMesh& b) {
  while (corners_.size() <= batch) {
    const std::size_t first = kTreeWidth * corners_.size();
    ExactPairs& filled = corners_.emplace_back();
    for (std::size_t lane = 0; lane < kTreeWidth; ++lane) {
      const TriangleIndices& pair = pairs_[std::min(first + lane, pairs_.size() - 1)].pair;
      const Corners of_a = a.corners(pair.a), of_b = b.corners(pair.b);
      for (std::size_t k = 0; k < 9; ++k) {
        filled.first[k][lane] = of_a[k / 3][static_cast<int>(k % 3)];
        filled.second[k][lane] = of_b[k / 3][static_cast<int>(k % 3)];
      }
    }
  }
  return corners_[batch];
}

void StepPairs::giveUp() {
  radius_ = -1.0;
  most_ *= kAfterCrowded;
}

}  // namespace hapticell::collision
