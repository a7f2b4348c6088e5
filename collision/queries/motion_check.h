// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// Distances are compared to this (m): far above rounding, far below what a thousand steps a second could add up.
inline constexpr double kRounding = 1e-11;
/// The stop is found to this much motion (m).
inline constexpr double kStopAccuracy = 1e-7;

/// How a part moves while s runs from 0 to 1: from X_WStart to X_WEnd along geometry's interpolate(), or, for a robot's
/// link, along what `along` says.
struct PartMotion {
  Pose X_WStart;
  Pose X_WEnd;
  double path_bound = 0.0;  ///< No point of the part moves faster than this: metres per unit of s; 0 stands still.
  double bend_bound = 0.0;  ///< No point's path bends more: |d2p/ds2| in metres; infinity where nobody knows.
  std::function<Pose(double)> along;  ///< X_WP at s, continuous; where empty, the straight motion.

  Pose at(double s) const { return along ? along(s) : interpolate(X_WStart, X_WEnd, s); }
};

/// A solid's motion from one pose to the other.
PartMotion straightMotion(const Pose& X_WStart, const Pose& X_WEnd, const MeshCollider& part);
PartMotion standingStill(const Pose& X_WP);

/// What stops a motion, and where.
struct MotionStop {
  double s = 1.0;                  ///< The motion is free up to here.
  bool stopped = false;            ///< s < 1 because something is in the way.
  bool began_colliding = false;    ///< The parts collided at s = 0.
  double distance_at_least = 0.0;  ///< Of the parts at s (m), as far as it is known; 0 where nothing is.
  DistanceResult nearest;          ///< At s, or just beyond it, of what stopped it; unset unless stopped.
};

/// What a motion must keep.
struct MotionDemand {
  double clearance = 0.0;  ///< Metres; less than kLeastClearance is raised to it.
  double until = 1.0;      ///< Only s up to here is looked at.
};

/// Clearance of 0 still means "not past contact": this much (m) is kept.
inline constexpr double kLeastClearance = 1e-6;

/// The largest s up to which A and B surely stay apart, by conservative advancement (Mirtich, "Impulse-based dynamic
/// simulation", 1996): the distance at s, divided by the speed bound, is a safe step; nothing thin is jumped over.
/// Near a surface the triangles that could meet are listed (NearPairs, kept by the query until worn out) and followed
/// one by one (sweepListed), so that along it a motion costs a step or two and no search. Where there are too many of
/// them, longer steps are proven box by box (staysApart), where the motions' bend is known.
///
/// At the returned s the parts are at least `clearance` apart; before it they may come nearer for a moment, but never
/// nearer than half of that. Parts that begin nearer than `clearance` need only keep the distance they began with, so
/// one can slide along and leave. Parts that begin colliding may move freely until they are apart (looked at every 2 mm
/// of motion), then as above. After 400 distance queries the motion ends where it is proven so far. Parts that touch
/// nothing on the way cost one query. Thread: that of `query`; no allocation
/// but what `along` does and the list's own, once.
MotionStop advance(ProximityQuery& query, const PartMotion& a, const PartMotion& b, const MotionDemand& demand);

}  // namespace hapticell::collision
