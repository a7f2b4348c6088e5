// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "collision/queries/distance_result.h"
#include "collision/queries/near_pairs.h"
#include "collision/queries/part_sweep.h"
#include "collision/queries/step_pairs.h"
#include "collision/queries/triangle_pairs.h"
#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// Requirements on an answer.
struct DistanceDemand {
  double limit = std::numeric_limits<double>::infinity();         ///< Distances from here on (m) are `beyond_limit`.
  double exact_within = std::numeric_limits<double>::infinity();  ///< Distances up to this (m) are exact;
  double tolerance = 0.0;  ///< larger ones may be too large by this share (0.03: at most 3 %), never too small.
};

/// Repeated proximity queries of one pair of colliders A and B; each starts from the last answer.
///
/// One object belongs to one thread at a time; different objects, also of the same colliders, may run at the same time.
/// Warm queries do not allocate. Poses are valid (Pose::isValid). After Larsen et al., "Fast proximity queries with
/// swept sphere volumes" (1999): the last nearest pair of triangles gives the first upper bound; after small steps the
/// pairs that the last search passed close by are measured, and nothing is searched (StepPairs).
class ProximityQuery {
 public:
  ProximityQuery(std::shared_ptr<const MeshCollider> a, std::shared_ptr<const MeshCollider> b);

  /// Distance and nearest points, exact up to rounding. If the distance is `limit` (m) or more, the answer is
  /// `beyond_limit`.
  DistanceResult distance(const Pose& X_WA, const Pose& X_WB, double limit = std::numeric_limits<double>::infinity());

  /// The same, as exact as `demand` requires. The nearest points have the returned distance.
  DistanceResult distance(const Pose& X_WA, const Pose& X_WB, const DistanceDemand& demand);

  /// Whether the surfaces touch or intersect, or one is inside the other's solid.
  bool collides(const Pose& X_WA, const Pose& X_WB);

  /// Whether the distance is `margin` (m) or less; ends at the first pair of triangles that is near enough.
  bool within(const Pose& X_WA, const Pose& X_WB, double margin);

  /// Whether the surfaces may come as near as `margin` (m) while both move by their sweeps. False is proven. True is
  /// also returned where they may only come within the margin plus what the sweeps move them against each other. Does
  /// not detect that one is inside the other.
  bool mayMeet(const SweptPose& a, const SweptPose& b, double margin, int effort = std::numeric_limits<int>::max());

  const MeshCollider& a() const { return *a_; }
  const MeshCollider& b() const { return *b_; }

  // For advance(), which keeps its list of near pairs here from motion to motion.
  NearPairs& near() { return near_; }
  /// As distance(), but searches only the listed pairs. The answer is exact up to the distance to which the list is
  /// complete at these poses, and not larger than that.
  DistanceResult distanceOfListed(const Pose& X_WA, const Pose& X_WB);
  /// States that the parts moved here from the poses of the last query without touching, and are this far apart (m).
  void certifyApart(const Pose& X_WA, const Pose& X_WB, double distance);

 private:
  bool isContained(const Pose& X_AB, double surface_distance);

  std::shared_ptr<const MeshCollider> a_;
  std::shared_ptr<const MeshCollider> b_;
  MotionLever lever_;
  TriangleIndices last_;
  bool last_was_near_ = true;  ///< The last search for something near found `last_`.
  NearPairs near_;
  StepPairs steps_;
  // Surfaces this far apart at that pose cannot have crossed after less motion, so containment has not changed.
  Pose certified_X_AB_;
  double certified_distance_ = -1.0;
  bool certified_contained_ = false;
};

/// A single query without earlier answers.
DistanceResult distance(const std::shared_ptr<const MeshCollider>& a, const Pose& X_WA,
                        const std::shared_ptr<const MeshCollider>& b, const Pose& X_WB,
                        double limit = std::numeric_limits<double>::infinity());

}  // namespace hapticell::collision
