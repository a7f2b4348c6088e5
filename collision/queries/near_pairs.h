// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "collision/queries/mesh_search.h"

namespace hapticell::collision {

/// The pairs of triangles of two meshes A and B that were near each other at one relative pose. While B has moved
/// less than the radius they were listed for, whatever comes near is among them, and no tree is searched.
///
/// One thread. Allocates for its first list only.
class NearPairs {
 public:
  static constexpr std::size_t kMost = 512;  ///< Longer lists cost more than the search that they save.

  /// Lists all pairs at most `radius` (m) apart with B at X_AB. False, and empty, where there are too many of them.
  bool fill(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius);
  void clear() { radius_ = -1.0; }

  /// A radius (m) that is likely to be short enough, as the lists before were.
  double likelyRadius() const { return likely_; }
  /// Lists had to be too short to be of use: longer ones are tried again, by and by.
  void forgive() { likely_ *= 1.05; }

  /// With B at X_AB every pair that is not listed is at least this far apart (m); negative: nothing is known.
  double reachAt(const Pose& X_AB) const;
  /// How far (m) any point of B has moved at most, seen from A, since the pairs were listed.
  double movedSince(const Pose& X_AB) const;

  /// With their distances as they were listed. Only while reachAt() is not negative.
  std::span<const TrianglePair> pairs() const { return pairs_; }

 private:
  std::vector<TrianglePair> pairs_;
  Pose X_AB_;
  dvec3 p_BS_{0.0};
  double sphere_ = 0.0;   ///< B's bounding sphere: its radius.
  double radius_ = -1.0;  ///< The pairs are complete up to here.
  double likely_ = 0.02;
};

}  // namespace hapticell::collision
