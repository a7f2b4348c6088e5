// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/proximity_query.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/listed_sweep.h"
#include "collision/queries/mesh_search.h"
#include "collision/queries/motion_bound.h"
#include "collision/queries/nearest_search.h"
#include "collision/queries/sweep_search.h"
#include "geometry/system/assertion.h"

namespace hapticell::collision {

namespace {

/// Unit normal of a triangle; of the other, turned round, when it has none.
dvec3 contactNormal(const Corners& of, const Corners& otherwise) {
  const dvec3 normal = glm::cross(of[1] - of[0], of[2] - of[0]);
  if (glm::length(normal) > 0.0) return glm::normalize(normal);
  const dvec3 other = glm::cross(otherwise[1] - otherwise[0], otherwise[2] - otherwise[0]);
  return glm::length(other) > 0.0 ? -glm::normalize(other) : dvec3(0.0, 0.0, 1.0);
}

DistanceResult beyond(double limit) {
  DistanceResult result;
  result.distance = limit;
  result.beyond_limit = true;
  return result;
}

DistanceResult resultOf(const NearestSearch& search, const Pose& X_WA) {
  DistanceResult result;
  result.triangle_A = search.pair().a;
  result.triangle_B = search.pair().b;
  const NearestPair& best = search.best();
  if (std::sqrt(best.squared) <= kTouchingDistance) {
    result.colliding = true;
    result.p_WA = result.p_WB = X_WA * (0.5 * (best.p + best.q));
    result.nhat_BA_W = X_WA.rotate(contactNormal(search.cornersB(search.pair().b), search.cornersA(search.pair().a)));
    return result;
  }
  result.p_WA = X_WA * best.p;
  result.p_WB = X_WA * best.q;
  result.distance = glm::distance(result.p_WA, result.p_WB);
  result.nhat_BA_W = (result.p_WA - result.p_WB) / result.distance;
  return result;
}

/// A point of a piece of `inner` that lies inside `outer`'s solid, in inner's frame; false if there is no such point.
bool pieceInside(const MeshCollider& inner, const MeshCollider& outer, const Pose& X_OuterInner, dvec3& p_Inner) {
  if (!outer.shells().anyClosed()) return false;
  // Points up to which each for itself is compared with the box: as many as a box takes. Half or twice as well.
  constexpr std::size_t kFewPoints = 4;
  const bool has_many = inner.shells().points().size() > kFewPoints;
  // Where the points that may be inside are, in inner's frame: no point needs to be placed to be left out.
  geometry::Bounds where;
  if (has_many) {
    const geometry::Bounds& box = outer.shells().closedBounds();
    const geometry::Bounds inner_box = geometry::transformed(X_OuterInner, inner.bounds());
    if (glm::any(glm::greaterThan(inner_box.min, box.max)) || glm::any(glm::lessThan(inner_box.max, box.min)))
      return false;
    where = geometry::transformed(X_OuterInner.inverse(), box);
    // More than the rounding of such a box; half or twice are as well.
    const double rounded = 1e-12 * (glm::length(where.size()) + glm::length(where.center()));
    where.min -= rounded;
    where.max += rounded;
  }
  for (const dvec3& point : inner.shells().points()) {
    if (has_many && (glm::any(glm::lessThan(point, where.min)) || glm::any(glm::greaterThan(point, where.max))))
      continue;
    if (!outer.contains(X_OuterInner * point)) continue;
    p_Inner = point;
    return true;
  }
  return false;
}

/// The answer for a piece of A inside B, or of B inside A; whether there is one.
bool containedResult(const MeshCollider& a, const Pose& X_WA, const MeshCollider& b, const Pose& X_WB,
                     DistanceResult& result) {
  const Pose X_AB = X_WA.inverse() * X_WB;
  result = {};
  result.colliding = result.contained = true;
  dvec3 p;
  if (pieceInside(a, b, X_AB.inverse(), p)) {
    const dvec3 p_B = X_AB.inverse() * p;
    const NearestPoint out = nearestPoint(b, p_B);
    result.p_WA = result.p_WB = X_WA * p;
    result.triangle_A = nearestPoint(a, p).triangle;
    result.triangle_B = out.triangle;
    if (out.distance > 0.0) result.nhat_BA_W = X_WB.rotate((out.p_MQ - p_B) / out.distance);
    return true;
  }
  if (!pieceInside(b, a, X_AB, p)) return false;
  const dvec3 p_A = X_AB * p;
  const NearestPoint out = nearestPoint(a, p_A);
  result.p_WA = result.p_WB = X_WB * p;
  result.triangle_A = out.triangle;
  result.triangle_B = nearestPoint(b, p).triangle;
  if (out.distance > 0.0) result.nhat_BA_W = X_WA.rotate((p_A - out.p_MQ) / out.distance);
  return true;
}

/// A pose, and how far apart (m) the surfaces are there at least.
struct Certificate {
  const Pose& X_AB;
  double distance;
};

/// No surface was crossed on the way from one to the other: every place between is
/// nearer to one end than what is free there. An arc is longer than its chord by a seventieth at most where the turn is
/// small.
bool staysApart(const Certificate& from, const Certificate& to, const MotionLever& lever) {
  // Cosine of half of the turn: 0.57 rad, at which an arc is longer than its chord by a seventieth (0.284 / sin 0.284).
  // A smaller turn would certify less, a larger one needs a larger share.
  constexpr double kSmallTurn = 0.96;
  constexpr double kArcOverChord = 1.0 + 1.0 / 70.0;
  const double motion = motionBound(lever, from.X_AB, to.X_AB);
  if (motion < from.distance) return true;
  const bool small = std::abs(glm::dot(from.X_AB.q, to.X_AB.q)) > kSmallTurn;
  return small && kArcOverChord * motion < from.distance + to.distance;
}

}  // namespace

ProximityQuery::ProximityQuery(std::shared_ptr<const MeshCollider> a, std::shared_ptr<const MeshCollider> b)
    : a_(std::move(a)), b_(std::move(b)) {
  HAPTICELL_DEMAND(a_ && b_);
  lever_ = leverOf(*a_, *b_);
  steps_ = StepPairs(lever_);
  if (a_->isEmpty() || b_->isEmpty()) return;
  last_ = {a_->tree().leaves().front().triangle[0], b_->tree().leaves().front().triangle[0]};
}

bool ProximityQuery::isContained(const Pose& X_AB, double surface_distance) {
  if (!a_->shells().anyClosed() && !b_->shells().anyClosed()) return false;
  if (!(certified_distance_ >= 0.0 &&
        staysApart({certified_X_AB_, certified_distance_}, {X_AB, surface_distance}, lever_))) {
    dvec3 ignored;
    certified_contained_ = pieceInside(*a_, *b_, X_AB.inverse(), ignored) || pieceInside(*b_, *a_, X_AB, ignored);
  }
  certified_X_AB_ = X_AB;
  certified_distance_ = surface_distance;
  return certified_contained_;
}

DistanceResult ProximityQuery::distance(const Pose& X_WA, const Pose& X_WB, double limit) {
  return distance(X_WA, X_WB, DistanceDemand{limit});
}

DistanceResult ProximityQuery::distance(const Pose& X_WA, const Pose& X_WB, const DistanceDemand& demanded) {
  const double limit = demanded.limit;
  if (a_->isEmpty() || b_->isEmpty()) return beyond(limit);
  const Pose X_AB = X_WA.inverse() * X_WB;
  SearchDemand demand;
  demand.enough = kTouchingDistance;
  demand.exact_within = demanded.exact_within;
  demand.tolerance = demanded.tolerance;
  if (limit < std::numeric_limits<double>::infinity()) demand.limit = std::max(limit, 2.0 * kTouchingDistance);
  NearestSearch search(*a_, *b_, X_AB, demand);
  const double reach = steps_.come(X_AB);
  if (reach > 0.0) search.runListed(last_, steps_);
  const bool is_known = demand.limit <= reach || (search.isFound() && search.best().squared <= reach * reach);
  if (reach <= 0.0 || !is_known) search.run(last_, &steps_);
  if (search.isFound()) last_ = search.pair();
  DistanceResult result = search.isFound() ? resultOf(search, X_WA) : beyond(limit);
  if (!result.colliding && result.distance >= limit) result = beyond(limit);
  if (result.colliding) {
    certified_distance_ = -1.0;
    return result;
  }
  if (isContained(X_AB, result.distance / (1.0 + demanded.tolerance))) containedResult(*a_, X_WA, *b_, X_WB, result);
  return result;
}

DistanceResult ProximityQuery::distanceOfListed(const Pose& X_WA, const Pose& X_WB) {
  const Pose X_AB = X_WA.inverse() * X_WB;
  const double reach = near_.reachAt(X_AB);
  DistanceResult result = beyond(reach);
  TriangleIndices pair;
  const NearestPair found = nearestListed(*a_, *b_, near_, X_AB, reach, pair);
  if (found.squared <= reach * reach) {
    last_ = pair;
    result.distance = std::sqrt(found.squared);
    result.beyond_limit = false;
    result.colliding = result.distance <= kTouchingDistance;
  }
  if (!result.colliding && isContained(X_AB, result.distance)) result.colliding = true;
  if (result.colliding) result.distance = 0.0;
  return result;
}

void ProximityQuery::certifyApart(const Pose& X_WA, const Pose& X_WB, double distance) {
  certified_X_AB_ = X_WA.inverse() * X_WB;
  certified_distance_ = distance;
  certified_contained_ = false;
}

bool ProximityQuery::collides(const Pose& X_WA, const Pose& X_WB) {
  return within(X_WA, X_WB, 0.0);
}

bool ProximityQuery::within(const Pose& X_WA, const Pose& X_WB, double margin) {
  if (a_->isEmpty() || b_->isEmpty()) return false;
  const Pose X_AB = X_WA.inverse() * X_WB;
  SearchDemand demand;
  demand.enough = std::max(margin, kTouchingDistance);
  demand.limit = demand.enough * (1.0 + 1e-12);
  NearestSearch search(*a_, *b_, X_AB, demand);
  if (steps_.reachAt(X_AB) >= demand.limit)
    search.runListed(last_, steps_);
  else if (last_was_near_)
    search.run(last_);
  else
    search.run();
  last_was_near_ = search.isFound();
  if (search.isFound()) {
    last_ = search.pair();
    return true;
  }
  return isContained(X_AB, demand.enough);
}

bool ProximityQuery::mayMeet(const SweptPose& a, const SweptPose& b, double margin, int effort) {
  if (a_->isEmpty() || b_->isEmpty()) return false;
  SweepSearch search(*a_, *b_, a.X_WP, b.X_WP, {a.sweep, b.sweep, margin, effort});
  return search.run(last_, last_was_near_);
}

DistanceResult distance(const std::shared_ptr<const MeshCollider>& a, const Pose& X_WA,
                        const std::shared_ptr<const MeshCollider>& b, const Pose& X_WB, double limit) {
  return ProximityQuery(a, b).distance(X_WA, X_WB, limit);
}

}  // namespace hapticell::collision
