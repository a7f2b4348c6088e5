// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "collision/queries/distance_result.h"
#include "collision/trees/mesh_collider.h"
#include "collision/queries/near_pairs.h"
#include "collision/queries/triangle_pairs.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// How exact an answer must be.
struct DistanceDemand {
  double limit = std::numeric_limits<double>::infinity();         ///< What is not nearer (m) is `beyond_limit`.
  double exact_within = std::numeric_limits<double>::infinity();  ///< Distances up to this (m) are exact;
  double tolerance = 0.0;  ///< those beyond may be told too large by this share (0.03: at most 3 %), never too small.
};

/// Repeated proximity queries of one pair of colliders A and B, each warmed by the last answer.
///
/// One object belongs to one thread at a time; different objects, also of the same colliders, may run at once. Queries
/// do not allocate. Poses are valid (Pose::isValid). After Larsen et al., "Fast proximity queries with swept sphere
/// volumes" (1999): the last nearest pair of triangles gives the first upper bound.
class ProximityQuery {
 public:
  ProximityQuery(std::shared_ptr<const MeshCollider> a, std::shared_ptr<const MeshCollider> b);

  /// Exact distance and nearest points, to rounding. Pairs not nearer than `limit` (m) are answered `beyond_limit`.
  DistanceResult distance(const Pose& X_WA, const Pose& X_WB, double limit = std::numeric_limits<double>::infinity());

  /// The same, exact only where it matters: the nearest points are of the distance told.
  DistanceResult distance(const Pose& X_WA, const Pose& X_WB, const DistanceDemand& demand);

  /// The surfaces touch or intersect, or one is inside the other's solid.
  bool collides(const Pose& X_WA, const Pose& X_WB);

  /// The distance is `margin` (m) or less; leaves at the first pair of triangles that shows it.
  bool within(const Pose& X_WA, const Pose& X_WB, double margin);

  const MeshCollider& a() const { return *a_; }
  const MeshCollider& b() const { return *b_; }

  // For advance(), which keeps its list of near pairs here from motion to motion.
  NearPairs& near() { return near_; }
  /// Distance and colliding as distance() tells them, looked for among the listed pairs only: exact up to where those
  /// are complete at these poses, and that at most.
  DistanceResult distanceOfListed(const Pose& X_WA, const Pose& X_WB);
  /// The parts came here without touching from where they were asked for last, and are so far apart (m).
  void certifyApart(const Pose& X_WA, const Pose& X_WB, double distance);

 private:
  bool isContained(const Pose& X_AB, double surface_distance);

  std::shared_ptr<const MeshCollider> a_;
  std::shared_ptr<const MeshCollider> b_;
  TriangleIndices last_;
  NearPairs near_;
  // Surfaces this far apart at that pose cannot have crossed after less motion: containment is then as it was.
  Pose certified_X_AB_;
  double certified_distance_ = -1.0;
  bool certified_contained_ = false;
};

/// One cold query.
DistanceResult distance(const std::shared_ptr<const MeshCollider>& a, const Pose& X_WA,
                        const std::shared_ptr<const MeshCollider>& b, const Pose& X_WB,
                        double limit = std::numeric_limits<double>::infinity());

}  // namespace hapticell::collision
