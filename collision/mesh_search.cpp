// SPDX-License-Identifier: Apache-2.0
#include "collision/mesh_search.h"

#include <algorithm>
#include <cmath>

#include "collision/ray.h"

namespace hapticell::collision {

namespace {

struct PointSearch {
  const BoxTree& tree;
  dvec3 point;
  double squared;
  NearestPoint nearest{};

  void visit(const BoxTree::Node& node) {
    if (!node.isLeaf()) {
      const BoxTree::Node* near = &tree.node(node.first);
      const BoxTree::Node* far = near + 1;
      double near_bound = lowerBoundSquared(near->box, point), far_bound = lowerBoundSquared(far->box, point);
      if (far_bound < near_bound) {
        std::swap(near, far);
        std::swap(near_bound, far_bound);
      }
      if (near_bound < squared) visit(*near);
      if (far_bound < squared) visit(*far);
      return;
    }
    for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
      const dvec3 q = closestPointOnTriangle(tree.corners(slot), point);
      const double candidate = glm::dot(q - point, q - point);
      if (candidate >= squared) continue;
      squared = candidate;
      nearest = {true, std::sqrt(candidate), q, tree.triangle(slot)};
    }
  }
};

struct RaySearch {
  const BoxTree& tree;
  Ray ray;
  RayHit hit{};

  void visit(const BoxTree::Node& node) {
    if (!node.isLeaf()) {
      const BoxTree::Node* near = &tree.node(node.first);
      const BoxTree::Node* far = near + 1;
      double near_entry = 0.0, far_entry = 0.0;
      bool meets_near = meetsBox(ray, near->box, hit.along, near_entry);
      bool meets_far = meetsBox(ray, far->box, hit.along, far_entry);
      if (meets_far && (!meets_near || far_entry < near_entry)) {
        std::swap(near, far);
        std::swap(meets_near, meets_far);
        std::swap(near_entry, far_entry);
      }
      if (meets_near) visit(*near);
      if (meets_far && far_entry <= hit.along) visit(*far);
      return;
    }
    for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
      const RayCrossing crossing = meetTriangle(ray, tree.corners(slot));
      if (!crossing.meets || crossing.along >= hit.along) continue;
      hit = {true, crossing.along, ray.origin + crossing.along * ray.direction, tree.triangle(slot)};
    }
  }
};

Corners transformedCorners(const dmat3& R, const dvec3& p, const Corners& c) {
  return {p + R * c[0], p + R * c[1], p + R * c[2]};
}

OrientedBox boxOf(const geometry::Bounds& bounds) {
  return {dmat3(1.0), bounds.center(), 0.5 * bounds.size()};
}

/// Distance of a triangle to a solid box: 0 when a corner is inside, else to the box's twelve face triangles.
double squaredDistance(const Corners& corners, const geometry::Bounds& box) {
  NearestPair best;
  for (const dvec3& corner : corners) {
    const dvec3 q = glm::clamp(corner, box.min, box.max);
    best.squared = std::min(best.squared, glm::dot(q - corner, q - corner));
  }
  if (best.squared == 0.0) return 0.0;
  const auto corner = [&](unsigned i) {
    return dvec3(i & 1u ? box.max.x : box.min.x, i & 2u ? box.max.y : box.min.y, i & 4u ? box.max.z : box.min.z);
  };
  constexpr unsigned kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    improveTriangleDistance({corner(f[0]), corner(f[1]), corner(f[2])}, corners, best);
    improveTriangleDistance({corner(f[0]), corner(f[2]), corner(f[3])}, corners, best);
  }
  return best.squared;
}

template <typename Bound, typename Take>
void collect(const BoxTree& tree, const BoxTree::Node& node, double squared, const Bound& bound, const Take& take) {
  if (bound(node.box) > squared) return;
  if (!node.isLeaf()) {
    collect(tree, tree.node(node.first), squared, bound, take);
    collect(tree, tree.node(node.first + 1), squared, bound, take);
    return;
  }
  for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) take(slot);
}

/// Calls take(slot_a, slot_b, nearest) for every pair of triangles within the radius; take returns false to stop.
/// Where it has wanted(slot_a, slot_b), only such pairs are measured, until isOver().
template <typename Take>
struct PairCollector {
  const BoxTree& tree_a;
  const BoxTree& tree_b;
  dmat3 R_AB;
  dvec3 p_AB;
  double squared;
  const Take& take;

  bool visit(const BoxTree::Node& a, const BoxTree::Node& b, const OrientedBox& box_b_A) {
    if (lowerBoundSquared(a.box, box_b_A) > squared) return true;
    if (a.isLeaf() && b.isLeaf()) return leaves(a, b);
    if (b.isLeaf() || (!a.isLeaf() && a.size >= b.size)) {
      return visit(tree_a.node(a.first), b, box_b_A) && visit(tree_a.node(a.first + 1), b, box_b_A);
    }
    const BoxTree::Node &left = tree_b.node(b.first), &right = tree_b.node(b.first + 1);
    return visit(a, left, moved(R_AB, p_AB, left.box)) && visit(a, right, moved(R_AB, p_AB, right.box));
  }

  bool leaves(const BoxTree::Node& a, const BoxTree::Node& b) {
    for (std::uint32_t j = b.first; j < b.first + b.count; ++j) {
      const Corners corners_b = transformedCorners(R_AB, p_AB, tree_b.corners(j));
      for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
        if constexpr (requires { take.wanted(i, j); }) {
          if (!take.wanted(i, j)) continue;
          if (take.isOver()) return false;
        }
        NearestPair nearest;
        nearest.squared = std::nextafter(squared, std::numeric_limits<double>::infinity());
        if (improveTriangleDistance(tree_a.corners(i), corners_b, nearest) && !take(i, j, nearest)) return false;
      }
    }
    return true;
  }
};

template <typename Take>
bool collectPairs(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius, const Take& take) {
  if (a.isEmpty() || b.isEmpty()) return true;
  const double reach = std::max(radius, kTouchingDistance);
  PairCollector<Take> collector{a.tree(), b.tree(), X_AB.R(), X_AB.p, reach * reach, take};
  return collector.visit(a.tree().root(), b.tree().root(), moved(collector.R_AB, collector.p_AB, b.tree().root().box));
}

}  // namespace

NearestPoint nearestPoint(const MeshCollider& mesh, const dvec3& p_MP, double limit) {
  if (mesh.isEmpty()) return {};
  PointSearch search{mesh.tree(), p_MP, limit * limit};
  if (lowerBoundSquared(mesh.tree().root().box, p_MP) < search.squared) search.visit(mesh.tree().root());
  return search.nearest;
}

RayHit castRay(const MeshCollider& mesh, const dvec3& p_MO, const dvec3& direction_M) {
  if (mesh.isEmpty() || !(glm::dot(direction_M, direction_M) > 0.0)) return {};
  RaySearch search{mesh.tree(), {p_MO, direction_M}};
  double entry = 0.0;
  if (meetsBox(search.ray, mesh.tree().root().box, search.hit.along, entry)) search.visit(mesh.tree().root());
  return search.hit;
}

void trianglesWithin(const MeshCollider& mesh, const dvec3& p_MP, double radius, std::vector<std::uint32_t>& found) {
  if (mesh.isEmpty()) return;
  const BoxTree& tree = mesh.tree();
  collect(
      tree, tree.root(), radius * radius, [&](const OrientedBox& box) { return lowerBoundSquared(box, p_MP); },
      [&](std::uint32_t slot) {
        const dvec3 q = closestPointOnTriangle(tree.corners(slot), p_MP);
        if (glm::distance(q, p_MP) <= radius) found.push_back(tree.triangle(slot));
      });
}

void trianglesWithin(const MeshCollider& mesh, const geometry::Bounds& box_M, double radius,
                     std::vector<std::uint32_t>& found) {
  if (mesh.isEmpty() || box_M.isEmpty()) return;
  const BoxTree& tree = mesh.tree();
  const OrientedBox oriented = boxOf(box_M);
  collect(
      tree, tree.root(), radius * radius, [&](const OrientedBox& box) { return lowerBoundSquared(box, oriented); },
      [&](std::uint32_t slot) {
        if (squaredDistance(tree.corners(slot), box_M) <= radius * radius) found.push_back(tree.triangle(slot));
      });
}

void trianglesWithin(const MeshCollider& b, const MeshCollider& a, const Pose& X_BA, double radius,
                     std::vector<std::uint32_t>& found_in_b) {
  const std::size_t before = found_in_b.size();
  collectPairs(b, a, X_BA, radius, [&](std::uint32_t slot_b, std::uint32_t, const NearestPair&) {
    found_in_b.push_back(b.tree().triangle(slot_b));
    return true;
  });
  const auto begin = found_in_b.begin() + static_cast<std::ptrdiff_t>(before);
  std::sort(begin, found_in_b.end());
  found_in_b.erase(std::unique(begin, found_in_b.end()), found_in_b.end());
}

namespace {

struct LabelCollector {
  const LabelledMesh& a;
  const LabelledMesh& b;
  SearchBudget& budget;
  std::vector<LabelPair>& found;
  mutable std::vector<bool> known{};
  mutable std::size_t looked = 0;

  std::size_t at(std::uint32_t slot_a, std::uint32_t slot_b) const {
    return std::size_t{b.labels} * a.label_of[a.mesh.tree().triangle(slot_a)] +
           b.label_of[b.mesh.tree().triangle(slot_b)];
  }
  bool wanted(std::uint32_t slot_a, std::uint32_t slot_b) const {
    constexpr std::size_t kLooksPerTest = 16;  // finding that a pair is known is so much cheaper
    if (++looked % kLooksPerTest == 0 && budget.tests > 0) --budget.tests;
    return budget.tests == 0 || !known[at(slot_a, slot_b)];
  }
  bool isOver() const { return budget.tests == 0 || --budget.tests == 0; }
  bool operator()(std::uint32_t slot_a, std::uint32_t slot_b, const NearestPair&) const {
    if (found.size() >= budget.pairs) return false;
    known[at(slot_a, slot_b)] = true;
    found.push_back({a.label_of[a.mesh.tree().triangle(slot_a)], b.label_of[b.mesh.tree().triangle(slot_b)]});
    return true;
  }
};

}  // namespace

bool labelPairsWithin(const LabelledMesh& a, const LabelledMesh& b, const Pose& X_AB, double radius,
                      SearchBudget& budget, std::vector<LabelPair>& found) {
  found.clear();
  LabelCollector collector{a, b, budget, found};
  collector.known.resize(std::size_t{a.labels} * b.labels);
  if (a.mesh.isEmpty() || b.mesh.isEmpty()) return true;
  return collectPairs(a.mesh, b.mesh, X_AB, radius, collector);
}

bool trianglePairsWithin(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius,
                         std::vector<TrianglePair>& found, std::size_t maximum) {
  return collectPairs(a, b, X_AB, radius, [&](std::uint32_t slot_a, std::uint32_t slot_b, const NearestPair& pair) {
    if (found.size() >= maximum) return false;
    found.push_back({a.tree().triangle(slot_a), b.tree().triangle(slot_b), std::sqrt(pair.squared), pair.p, pair.q});
    return true;
  });
}

}  // namespace hapticell::collision
