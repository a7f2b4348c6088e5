// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/near_pairs.h"

#include <algorithm>

namespace hapticell::collision {

namespace {

/// By which the likely radius shrinks when there were too many pairs, and grows when there were under a quarter. Pairs
/// grow with its square: 0.3 gives a tenth, 1.5 twice. Half or twice: more failed tries.
constexpr double kAfterCrowded = 0.3, kAfterRoomy = 1.5;
/// m: wider lists serve no step of a hand. Half: fast hands (over 10 mm a step) search; twice: long lists of what is
/// far.
constexpr double kWidest = 0.02;

}  // namespace

bool NearPairs::fill(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius) {
  lever_ = leverOf(a, b);
  radius_ = -1.0;
  pairs_.clear();
  pairs_.reserve(kMost);
  if (!trianglePairsWithin(a, b, X_AB, radius, pairs_, kMost)) {
    likely_ = kAfterCrowded * radius;
    return false;
  }
  if (pairs_.size() < kMost / 4) likely_ = std::min(kWidest, std::max(likely_, kAfterRoomy * radius));
  X_AB_ = X_AB;
  radius_ = radius;
  return true;
}

double NearPairs::movedSince(const Pose& X_AB) const {
  return motionBound(lever_, X_AB_, X_AB);
}

double NearPairs::reachAt(const Pose& X_AB) const {
  return radius_ < 0.0 ? radius_ : radius_ - movedSince(X_AB);
}

}  // namespace hapticell::collision
