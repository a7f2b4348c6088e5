// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// Tolerance (m) for comparing distances: 1e5 times the rounding at 1 m, and 1000 steps a second add up to 1e-8 m. Half
/// and twice: still far from both.
inline constexpr double kRounding = 1e-11;
/// Accuracy of the stop, as motion (m): a tenth of kLeastClearance. Half: one query more a stop; twice: one less.
inline constexpr double kStopAccuracy = 1e-7;

/// How a part moves while s runs from 0 to 1: from X_WStart to X_WEnd along geometry's interpolate(), or, for a robot's
/// link, along what `along` says.
struct PartMotion {
  Pose X_WStart;
  Pose X_WEnd;
  double path_bound = 0.0;  ///< No point of the part moves faster than this: metres per unit of s; 0: the part does not
                            ///< move.
  double bend_bound = 0.0;  ///< No point's path bends more: |d2p/ds2| in metres; infinity if unknown.
  std::function<Pose(double)> along;  ///< X_WP at s, continuous; empty: the straight motion.

  Pose at(double s) const { return along ? along(s) : interpolate(X_WStart, X_WEnd, s); }
};

/// A solid's motion from one pose to the other.
PartMotion straightMotion(const Pose& X_WStart, const Pose& X_WEnd, const MeshCollider& part);
PartMotion standingStill(const Pose& X_WP);

/// What stops a motion, and where.
struct MotionStop {
  double s = 1.0;                  ///< The motion is free up to here.
  bool stopped = false;            ///< s < 1 because something blocks the way.
  bool began_colliding = false;    ///< The parts collided at s = 0.
  double distance_at_least = 0.0;  ///< Lower bound of the parts' distance at s (m); 0 if unknown.
  DistanceResult nearest;          ///< At s, or just beyond it, of what stopped it; unset unless stopped.
};

/// Requirements on a motion.
struct MotionDemand {
  double clearance = 0.0;  ///< Metres; less than kLeastClearance is raised to it.
  double until = 1.0;      ///< Only s up to here is checked.
};

/// Least clearance (m): also for a clearance of 0, parts do not pass contact. A thousand times kTouchingDistance, a
/// twentieth of kSkin. Half: more queries at each contact; twice: parts stay 2 um apart.
inline constexpr double kLeastClearance = 1e-6;

/// The largest s up to which A and B surely stay apart, by conservative advancement (Mirtich, "Impulse-based dynamic
/// simulation", 1996): the distance at s, divided by the speed bound, is a safe step, so thin parts are not skipped.
/// Near a surface the triangles that could meet are listed (NearPairs, kept by the query as long as they are valid) and
/// followed one by one (sweepListed()). A motion along a surface then costs a step or two and no search. If there are
/// too many such triangles and the motions' bend is known, longer steps are proven box by box (staysApart()).
///
/// At the returned s the parts are at least `clearance` apart; before it they may come nearer for a moment, but never
/// nearer than half of that. Parts that begin nearer than `clearance` only need to keep the distance that they began
/// with, so they can slide along and leave. Parts that begin colliding may move freely until they are apart (checked
/// every 2 mm of motion), then as above. After 400 distance queries the motion ends at the last proven s. If the parts
/// touch nothing on the way, it costs one query. Thread: that of `query`. No allocation except in `along` and, once,
/// for the list.
MotionStop advance(ProximityQuery& query, const PartMotion& a, const PartMotion& b, const MotionDemand& demand);

}  // namespace hapticell::collision
