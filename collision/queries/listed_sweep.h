// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/queries/motion_check.h"
#include "collision/queries/near_pairs.h"

namespace hapticell::collision {

/// A stretch of a motion of two meshes, and what it must keep.
struct ListedStretch {
  double from = 0.0, to = 1.0;  ///< Of s.
  double clearance = 0.0;       ///< Metres; at `from` the meshes are no nearer.
};

/// What was found on it.
struct ListedStop {
  double s = 1.0;                  ///< Free up to here.
  bool stopped = false;            ///< Before the end: something comes nearer than the clearance there.
  double distance_at_least = 0.0;  ///< Of the meshes at s, m.
  NearestPair nearest;             ///< When stopped: at s, in the world,
  TriangleIndices pair;            ///< of these triangles.
};

/// Follows the listed pairs of triangles along the stretch, each for itself: the gap on the line of its nearest points,
/// which two convex shapes on nearly straight paths close no faster than their ends and their bend tell, is a step that
/// is surely free (conservative advancement with directions, after Tang, Kim and Manocha, "C2A", 2009). So sliding
/// along something costs a step or two however small the gap. At the stop all pairs keep the clearance; before it they
/// may come nearer for a moment, never nearer than half of it.
///
/// Contract: the list is complete up to clearance + (path bounds of both) * (to - from) at `from`. No allocation but
/// what the motions do.
ListedStop sweepListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const PartMotion& motion_a,
                       const PartMotion& motion_b, const ListedStretch& stretch);

/// The nearest of the listed pairs at a pose, in A's frame; infinitely far where none is nearer than `limit` (m).
NearestPair nearestListed(const MeshCollider& a, const MeshCollider& b, const NearPairs& near, const Pose& X_AB,
                          double limit, TriangleIndices& pair);

}  // namespace hapticell::collision
