// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "collision/queries/mesh_search.h"
#include "collision/queries/motion_bound.h"

namespace hapticell::collision {

/// The pairs of triangles of two meshes A and B that were near each other at one relative pose. As long as B has moved
/// less than the radius of the list, all pairs that come near are in it, and no tree is searched.
///
/// One thread. Allocates for its first list only.
class NearPairs {
 public:
  /// Pairs; longer lists cost more than a search. Half: more searches in grooves; twice: slower steps there.
  static constexpr std::size_t kMost = 512;

  /// Lists all pairs at most `radius` (m) apart with B at X_AB. If there are too many, returns false and the list is
  /// empty.
  bool fill(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius);
  void clear() { radius_ = -1.0; }

  /// A radius (m) that, judging by earlier lists, does not give too many pairs.
  double likelyRadius() const { return likely_; }
  /// The radius was too small to be of use: increases likelyRadius() a little.
  void forgive() { likely_ *= 1.05; }

  /// With B at X_AB every pair that is not listed is at least this far apart (m); negative: unknown.
  double reachAt(const Pose& X_AB) const;
  /// By how much (m) any distance between A and B has changed at most since the pairs were listed.
  double movedSince(const Pose& X_AB) const;

  /// The pairs, with their distances at the time of listing. Valid only if reachAt() is not negative.
  std::span<const TrianglePair> pairs() const { return pairs_; }

 private:
  std::vector<TrianglePair> pairs_;
  Pose X_AB_;
  MotionLever lever_;
  double radius_ = -1.0;  ///< The list is complete up to this radius.
  double likely_ = 0.02;
};

}  // namespace hapticell::collision
