// SPDX-License-Identifier: Apache-2.0
#include "planning/own_pair_motion.h"

#include <algorithm>
#include <limits>

#include "collision/queries/motion_check.h"

namespace hapticell::planning {

namespace {

/// m of motion: shorter pieces are not halved but followed by their distance. Half: one halving more near contact;
/// twice: longer pieces to follow there, at 10 to 20 us a distance.
constexpr double kShortPiece = 2e-3;
/// Of a piece of an own pair's motion, against the radius of the smaller part: longer ones are halved without a search,
/// which mostly tells nothing. Half, twice: some more halvings or searches.
constexpr double kSearchedSize = 1.0;
/// Pieces of a motion that wait: halvings from 2^60 m down to the above.
constexpr int kMostOpen = 64;

}  // namespace

collision::MotionStop leadOwnPair(collision::ProximityQuery& query, const OwnPair& pair, PlannedMotion& motion,
                                  double way, const MotionPiece& piece) {
  const double length = piece.to - piece.from;
  const Pose X_WA0 = motion.poseOf(pair.part, piece.from);
  collision::PartMotion met;
  met.path_bound = way * length;
  met.bend_bound = std::numeric_limits<double>::infinity();
  met.along = [&](double s) {
    const double at = piece.from + s * length;
    return X_WA0 * (motion.poseOf(pair.part, at).inverse() * motion.poseOf(pair.other, at));
  };
  return collision::advance(query, collision::standingStill(X_WA0), met, {0.0, 1.0});
}

double spheresApart(const collision::ProximityQuery& query, const Pose& X_WA, const Pose& X_WB) {
  const collision::MeshCollider &a = query.a(), &b = query.b();
  return glm::distance(X_WA * a.center(), X_WB * b.center()) - a.radius() - b.radius();
}

bool ownPairTouches(collision::ProximityQuery& query, const OwnPair& pair, PlannedMotion& motion, double way) {
  const double longest = std::max(kShortPiece, kSearchedSize * std::min(query.a().radius(), query.b().radius()));
  MotionPiece open[kMostOpen];
  int count = 1;
  while (count > 0) {
    const MotionPiece piece = open[--count];
    const double middle = 0.5 * (piece.from + piece.to), length = way * (piece.to - piece.from);
    if (length > longest && count + 2 <= kMostOpen) {
      open[count++] = {middle, piece.to};
      open[count++] = {piece.from, middle};
      continue;
    }
    const Pose X_WA = motion.poseOf(pair.part, middle), X_WB = motion.poseOf(pair.other, middle);
    const double margin = collision::kLeastClearance + 0.5 * length + collision::kRounding;
    if (spheresApart(query, X_WA, X_WB) > margin || !query.within(X_WA, X_WB, margin)) continue;
    if (length <= kShortPiece || count + 2 > kMostOpen) {
      const auto stop = leadOwnPair(query, pair, motion, way, piece);
      if (stop.stopped || stop.began_colliding) return true;
      continue;
    }
    if (query.within(X_WA, X_WB, collision::kLeastClearance)) return true;
    open[count++] = {middle, piece.to};
    open[count++] = {piece.from, middle};
  }
  return false;
}

}  // namespace hapticell::planning
