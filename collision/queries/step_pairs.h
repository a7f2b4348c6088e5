// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "collision/queries/motion_bound.h"
#include "collision/queries/triangle_pairs.h"
#include "collision/trees/proximity_kernels.h"

namespace hapticell::collision {

/// The pairs of triangles of two meshes A and B that a search for the nearest passed close by: after a small step only
/// these can be nearest, and no tree is searched. Decides how widely a search collects, from the steps and from how
/// many pairs earlier lists held.
///
/// One thread. Allocates for its first list only.
class StepPairs {
 public:
  /// Pairs of a list: measuring half of them takes about a microsecond, a search ten. Half: more searches; twice:
  /// slower steps where triangles are small.
  static constexpr std::size_t kMost = 128;
  /// Pairs while the search still narrows: more seldom end as a list, and collecting them takes longest of all. Less:
  /// no room for what narrows away; 1.6 times: p99 of small steps 6 to 8 % higher.
  static constexpr std::size_t kMostOnTheWay = kMost + kMost / 4;

  struct Pair {
    TriangleIndices pair;
    float least = 0.0F;  ///< Their distance is not below this (m), when they were listed.
  };

  StepPairs() = default;
  explicit StepPairs(const MotionLever& lever) : lever_(lever) {}

  /// The next query of the same pair is at X_AB: the steps say how widely to collect. Returns reachAt().
  double come(const Pose& X_AB);
  /// Up to this distance (m) the list has every pair with B at X_AB; negative: nothing is known.
  double reachAt(const Pose& X_AB) const { return radius_ < 0.0 ? radius_ : radius_ - movedSince(X_AB); }
  double movedSince(const Pose& X_AB) const { return motionBound(lever_, X_AB_, X_AB); }
  /// Smallest distances first.
  std::span<const Pair> pairs() const { return pairs_; }
  /// Corners of the eight pairs from the `batch`-th eighth on, each in its own mesh's frame; lanes that are not used
  /// repeat the last pair. They are gathered when they are first asked for, in order.
  const ExactPairs& corners(std::size_t batch, const geometry::TriangleMesh& a, const geometry::TriangleMesh& b);

  /// Called when a search begins: how far (m) beyond the nearest pair it should collect; 0: collect nothing.
  double begin();
  /// False where there are too many.
  bool add(const TriangleIndices& pair, float least);
  /// The search has ended: every pair nearer than `radius` (m) was added.
  void finish(double radius);
  /// The search ended early, or there were too many pairs: the list is invalid.
  void giveUp();

 private:
  MotionLever lever_;
  std::vector<Pair> pairs_;
  std::vector<ExactPairs> corners_;
  Pose X_AB_;          ///< Of the list,
  Pose X_ABNow_;       ///< and of the last query;
  double step_ = 0.0;  ///< from the one before, m.
  bool has_come_ = false;
  double radius_ = -1.0;
  double most_ = 0.01;  ///< m: wider lists held too many pairs.
};

}  // namespace hapticell::collision
