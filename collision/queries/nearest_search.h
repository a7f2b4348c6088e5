// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "collision/queries/step_pairs.h"
#include "collision/queries/triangle_pairs.h"
#include "collision/trees/dual_traversal.h"
#include "collision/trees/mesh_collider.h"
#include "collision/trees/triangle_distance.h"

namespace hapticell::collision {

/// Requirements on the nearest pair.
struct SearchDemand {
  double limit = std::numeric_limits<double>::infinity();         ///< Search only for pairs nearer than this (m).
  double enough = 0.0;                                            ///< A pair this near (m) ends the search.
  double exact_within = std::numeric_limits<double>::infinity();  ///< Up to here (m) the answer is exact,
  double tolerance = 0.0;                                         ///< beyond it at most this share too large.
};

/// The search for the nearest pair of triangles of two meshes, all in A's frame. A visitor of DualTraversal: it
/// collects triangle pairs, measures many at a time in float, and measures candidates for the nearest again in double.
/// One object per query, on the stack.
class NearestSearch {
 public:
  NearestSearch(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, const SearchDemand& demand);

  /// Measures the pair `warm`, which is probably near, and the listed ones only: the answer is exact if it is not
  /// farther than the list reaches.
  void runListed(const TriangleIndices& warm, StepPairs& list);
  /// Searches the trees; where a list is given, lists what it passes close by.
  void run(StepPairs* list = nullptr);
  /// The same, but measures the pair `warm` first, which is probably near.
  void run(const TriangleIndices& warm, StepPairs* list = nullptr);

  bool isFound() const { return found_; }
  const NearestPair& best() const { return best_; }
  const TriangleIndices& pair() const { return pair_; }
  Corners cornersA(std::uint32_t triangle) const;
  Corners cornersB(std::uint32_t triangle) const;  ///< In A's frame.

  // For DualTraversal.
  float limitSquared() const { return prune_squared_; }
  const float* line(bool in_a) const { return in_a ? line_a_ : line_b_; }
  bool isDone() const { return done_; }
  void leafPair(const TraversalBox& a, const TraversalBox& b, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                const LeafTransform& transform);

  /// Measures a pair in double.
  void tryPair(const TriangleIndices& pair);
  /// Measures the collected pairs.
  void flush();

 private:
  void begin(StepPairs* list);
  void search();
  void pruneFrom(double distance);
  void aim();
  void tryTies(std::uint32_t lanes);
  void tryExactly(const TriangleIndices* tried, int count);
  bool mayImprove(const ExactPairs& pairs, int count) const;
  void measure(const ExactPairs& pairs, const TriangleIndices* tried, int count);
  void collect(int count);
  void stopCollecting();

  const MeshCollider& a_;
  const MeshCollider& b_;
  StepPairs* list_ = nullptr;  ///< While it collects,
  double slack_ = 0.0;         ///< so far beyond the nearest (m).
  dmat3 R_AB_;
  dvec3 p_AB_;
  Pose X_AB_;
  SearchDemand demand_;
  NearestPair best_;
  TriangleIndices pair_;
  double line_[3] = {};                    ///< From the nearest point of A to that of B, a unit vector, in A's frame;
  float line_a_[3] = {}, line_b_[3] = {};  ///< the same, in each mesh's frame.
  bool found_ = false;
  bool done_ = false;
  float prune_squared_ = std::numeric_limits<float>::infinity();
  int packed_ = 0;
  int eager_ = kPackSize;  ///< So many collected pairs are measured without waiting for more.
  TriangleIndices packed_pair_[kPackSize];
  PackedPairs pack_;
  PackedDistances distances_;
};

}  // namespace hapticell::collision
