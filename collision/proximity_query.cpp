// SPDX-License-Identifier: Apache-2.0
#include "collision/proximity_query.h"

#include <algorithm>
#include <cmath>

#include "collision/mesh_search.h"
#include "collision/motion_bound.h"
#include "geometry/assertion.h"

namespace hapticell::collision {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Nodes that cannot improve the distance by more than this (m) are passed over: ties are common on CAD parts.
constexpr double kNegligible = 5e-10;

/// Leaves this many times larger than the other node are looked at by their triangles.
constexpr double kMuchLarger = 2.0;

/// Depth-first search for the nearest pair of triangles, all in A's frame.
struct PairSearch {
  const BoxTree& tree_a;
  const BoxTree& tree_b;
  dmat3 R_AB;
  dvec3 p_AB;
  double enough = kTouchingDistance;  ///< A pair this near ends the search.
  NearestPair best{};
  std::uint32_t slot_a = 0;
  std::uint32_t slot_b = 0;
  bool found = false;
  bool done = false;
  double prune_squared = kInfinity;

  void limitTo(double distance) {
    best.squared = distance * distance;
    prune_squared = best.squared;
  }

  Corners cornersOfB(std::uint32_t slot) const {
    const Corners& c = tree_b.corners(slot);
    return {p_AB + R_AB * c[0], p_AB + R_AB * c[1], p_AB + R_AB * c[2]};
  }

  void tryPair(std::uint32_t a, std::uint32_t b, const Corners& corners_b) {
    if (!improveTriangleDistance(tree_a.corners(a), corners_b, best)) return;
    slot_a = a;
    slot_b = b;
    found = true;
    const double distance = std::sqrt(best.squared);
    done = distance <= enough;
    const double prune = std::max(distance - kNegligible, 0.0);
    prune_squared = prune * prune;
  }

  void leaves(const BoxTree::Node& a, const BoxTree::Node& b) {
    for (std::uint32_t j = b.first; j < b.first + b.count && !done; ++j) {
      const Corners corners_b = cornersOfB(j);
      for (std::uint32_t i = a.first; i < a.first + a.count && !done; ++i) tryPair(i, j, corners_b);
    }
  }

  void visit(const BoxTree::Node& a, const BoxTree::Node& b, const OrientedBox& box_b_A) {
    if (isBeyond(a, b, box_b_A)) return;
    if (a.isLeaf() && b.isLeaf()) {
      leaves(a, b);
    } else if (b.isLeaf() || (!a.isLeaf() && a.size >= b.size)) {
      openA(a, b, box_b_A);
    } else {
      openB(a, b);
    }
  }

  /// A leaf's own triangles tell more than its box where they are larger than the other node: the box of a long,
  /// slanting triangle comes nearer by more than the other node's size, and every triangle under that node would be
  /// tried.
  bool isBeyond(const BoxTree::Node& a, const BoxTree::Node& b, const OrientedBox& box_b_A) const {
    const bool by_b = b.isLeaf() && b.size > kMuchLarger * a.size, by_a = a.isLeaf() && a.size > kMuchLarger * b.size;
    if (!by_b && !by_a) return false;
    const BoxTree::Node& leaf = by_b ? b : a;
    const OrientedBox& box = by_b ? a.box : box_b_A;
    for (std::uint32_t slot = leaf.first; slot < leaf.first + leaf.count; ++slot) {
      if (lowerBoundSquared(box, by_b ? cornersOfB(slot) : tree_a.corners(slot)) < prune_squared) return false;
    }
    return true;
  }

  void openA(const BoxTree::Node& a, const BoxTree::Node& b, const OrientedBox& box_b_A) {
    const BoxTree::Node* near = &tree_a.node(a.first);
    const BoxTree::Node* far = near + 1;
    double near_bound = lowerBoundSquared(near->box, box_b_A), far_bound = lowerBoundSquared(far->box, box_b_A);
    if (far_bound < near_bound) {
      std::swap(near, far);
      std::swap(near_bound, far_bound);
    }
    if (near_bound < prune_squared) visit(*near, b, box_b_A);
    if (far_bound < prune_squared && !done) visit(*far, b, box_b_A);
  }

  void openB(const BoxTree::Node& a, const BoxTree::Node& b) {
    const BoxTree::Node* near = &tree_b.node(b.first);
    const BoxTree::Node* far = near + 1;
    OrientedBox near_box = moved(R_AB, p_AB, near->box), far_box = moved(R_AB, p_AB, far->box);
    double near_bound = lowerBoundSquared(a.box, near_box), far_bound = lowerBoundSquared(a.box, far_box);
    if (far_bound < near_bound) {
      std::swap(near, far);
      std::swap(near_box, far_box);
      std::swap(near_bound, far_bound);
    }
    if (near_bound < prune_squared) visit(a, *near, near_box);
    if (far_bound < prune_squared && !done) visit(a, *far, far_box);
  }

  void run(std::uint32_t warm_a, std::uint32_t warm_b) {
    tryPair(warm_a, warm_b, cornersOfB(warm_b));
    const OrientedBox root_b = moved(R_AB, p_AB, tree_b.root().box);
    if (!done && lowerBoundSquared(tree_a.root().box, root_b) < prune_squared)
      visit(tree_a.root(), tree_b.root(), root_b);
  }
};

PairSearch searchOf(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB) {
  return {a.tree(), b.tree(), X_AB.R(), X_AB.p};
}

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

DistanceResult resultOf(const PairSearch& search, const Pose& X_WA) {
  DistanceResult result;
  result.triangle_A = search.tree_a.triangle(search.slot_a);
  result.triangle_B = search.tree_b.triangle(search.slot_b);
  if (std::sqrt(search.best.squared) <= kTouchingDistance) {
    result.colliding = true;
    result.p_WA = result.p_WB = X_WA * (0.5 * (search.best.p + search.best.q));
    result.nhat_BA_W =
        X_WA.rotate(contactNormal(search.cornersOfB(search.slot_b), search.tree_a.corners(search.slot_a)));
    return result;
  }
  result.p_WA = X_WA * search.best.p;
  result.p_WB = X_WA * search.best.q;
  result.distance = glm::distance(result.p_WA, result.p_WB);
  result.nhat_BA_W = (result.p_WA - result.p_WB) / result.distance;
  return result;
}

/// A point of a piece of `inner` that lies inside `outer`'s solid, in inner's frame; false when there is none.
bool pieceInside(const MeshCollider& inner, const MeshCollider& outer, const Pose& X_OuterInner, dvec3& p_Inner) {
  if (!outer.shells().anyClosed()) return false;
  const geometry::Bounds& box = outer.shells().closedBounds();
  const geometry::Bounds inner_box = geometry::transformed(X_OuterInner, inner.bounds());
  if (glm::any(glm::greaterThan(inner_box.min, box.max)) || glm::any(glm::lessThan(inner_box.max, box.min)))
    return false;
  for (const dvec3& point : inner.shells().points()) {
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

}  // namespace

ProximityQuery::ProximityQuery(std::shared_ptr<const MeshCollider> a, std::shared_ptr<const MeshCollider> b)
    : a_(std::move(a)), b_(std::move(b)) {
  HAPTICELL_DEMAND(a_ && b_);
}

bool ProximityQuery::isContained(const Pose& X_AB, double surface_distance) {
  if (!a_->shells().anyClosed() && !b_->shells().anyClosed()) return false;
  const double motion = motionBound(certified_X_AB_, X_AB, b_->center(), b_->radius());
  if (!(certified_distance_ >= 0.0 && motion < certified_distance_)) {
    dvec3 ignored;
    certified_contained_ = pieceInside(*a_, *b_, X_AB.inverse(), ignored) || pieceInside(*b_, *a_, X_AB, ignored);
  }
  certified_X_AB_ = X_AB;
  certified_distance_ = surface_distance;
  return certified_contained_;
}

DistanceResult ProximityQuery::distance(const Pose& X_WA, const Pose& X_WB, double limit) {
  if (a_->isEmpty() || b_->isEmpty()) return beyond(limit);
  const Pose X_AB = X_WA.inverse() * X_WB;
  PairSearch search = searchOf(*a_, *b_, X_AB);
  if (limit < kInfinity) search.limitTo(std::max(limit, 2.0 * kTouchingDistance));
  search.run(last_slot_a_, last_slot_b_);
  if (search.found) {
    last_slot_a_ = search.slot_a;
    last_slot_b_ = search.slot_b;
  }
  DistanceResult result = search.found ? resultOf(search, X_WA) : beyond(limit);
  if (!result.colliding && result.distance >= limit) result = beyond(limit);
  if (result.colliding) {
    certified_distance_ = -1.0;
    return result;
  }
  if (isContained(X_AB, result.distance)) containedResult(*a_, X_WA, *b_, X_WB, result);
  return result;
}

bool ProximityQuery::collides(const Pose& X_WA, const Pose& X_WB) {
  return within(X_WA, X_WB, 0.0);
}

bool ProximityQuery::within(const Pose& X_WA, const Pose& X_WB, double margin) {
  if (a_->isEmpty() || b_->isEmpty()) return false;
  const Pose X_AB = X_WA.inverse() * X_WB;
  PairSearch search = searchOf(*a_, *b_, X_AB);
  const double enough = std::max(margin, kTouchingDistance);
  search.enough = enough;
  search.limitTo(enough * (1.0 + 1e-12));
  search.run(last_slot_a_, last_slot_b_);
  if (search.found) {
    last_slot_a_ = search.slot_a;
    last_slot_b_ = search.slot_b;
    return true;
  }
  return isContained(X_AB, enough);
}

DistanceResult distance(const std::shared_ptr<const MeshCollider>& a, const Pose& X_WA,
                        const std::shared_ptr<const MeshCollider>& b, const Pose& X_WB, double limit) {
  return ProximityQuery(a, b).distance(X_WA, X_WB, limit);
}

}  // namespace hapticell::collision
