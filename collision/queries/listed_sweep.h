// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/queries/motion_check.h"
#include "collision/queries/near_pairs.h"

namespace hapticell::collision {

/// A stretch of a motion of two meshes, and the clearance to keep.
struct ListedStretch {
  double from = 0.0, to = 1.0;  ///< Of s.
  double clearance = 0.0;       ///< Metres; at `from` the meshes are not nearer than this.
};

/// The result of sweepListed().
struct ListedStop {
  double s = 1.0;                  ///< Free up to here.
  bool stopped = false;            ///< Stopped before the end, where something comes nearer than the clearance.
  double distance_at_least = 0.0;  ///< Of the meshes at s, m.
  NearestPair nearest;             ///< When stopped: at s, in the world,
  TriangleIndices pair;            ///< of these triangles.
};

/// Follows each listed pair of triangles along the stretch. The step length follows from the gap along the line of the
/// nearest points: two convex shapes on nearly straight paths close it no faster than the ends and the bend of the
/// paths allow, so the step is free (conservative advancement with directions, after Tang, Kim and Manocha, "C2A",
/// 2009). Sliding along a surface therefore costs a step or two, however small the gap. At the stop all pairs keep the
/// clearance; before it they may come nearer for a moment, but never nearer than half of it.
///
/// Contract: the list is complete up to clearance + (path bounds of both) * (to - from) at `from`. No allocation except
/// by the motions.
ListedStop sweepListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const PartMotion& motion_a,
                       const PartMotion& motion_b, const ListedStretch& stretch);

/// The nearest of the listed pairs at a pose, in A's frame; at infinite distance if no pair is nearer than `limit` (m).
NearestPair nearestListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const Pose& X_AB,
                          double limit, TriangleIndices& pair);

}  // namespace hapticell::collision
