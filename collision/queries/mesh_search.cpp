// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/mesh_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_set>

#include "collision/queries/distance_result.h"
#include "collision/trees/dual_traversal.h"
#include "collision/trees/ray.h"

namespace hapticell::collision {

namespace {

/// What boxes of a tree are compared with, in the mesh's frame.
struct Probe {
  OrientedBox box;

  void bounds(const BoxNode& node, float* squared) const {
    QueryBox query;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) query.axis[i][k] = static_cast<float>(box.R[i][k]);
      query.center[i] = static_cast<float>(box.center[i] - double{node.origin[i]});
      query.half[i] = static_cast<float>(box.half[i]);
    }
    proximityKernels().boxBounds(node, query, 0.0f, squared);
  }
};

/// Calls open(child) for the lanes nearer than limit(), the nearest first.
template <typename Limit, typename Open>
void openNearestFirst(const BoxNode& node, const Probe& probe, const Limit& limit, const Open& open) {
  alignas(32) float bounds[kTreeWidth];
  probe.bounds(node, bounds);
  for (std::uint32_t left = (1u << node.count) - 1u; left != 0;) {
    int nearest = std::countr_zero(left);
    for (int lane = nearest + 1; lane < kTreeWidth; ++lane) {
      if ((left >> lane & 1u) != 0 && bounds[lane] < bounds[nearest]) nearest = lane;
    }
    if (double{bounds[nearest]} > limit()) return;
    left &= ~(1u << nearest);
    open(node.child[nearest]);
  }
}

struct PointSearch {
  const MeshCollider& mesh;
  Probe probe;
  dvec3 point;
  double squared;
  NearestPoint nearest{};

  void visit(std::uint32_t child) {
    if (!BoxTree::isLeaf(child)) {
      openNearestFirst(
          mesh.tree().node(child), probe, [this] { return squared; }, [this](std::uint32_t below) { visit(below); });
      return;
    }
    const LeafBlock& leaf = mesh.tree().leaf(child);
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const dvec3 q = closestPointOnTriangle(mesh.mesh().corners(leaf.triangle[i]), point);
      const double candidate = glm::dot(q - point, q - point);
      if (candidate >= squared) continue;
      squared = candidate;
      nearest = {true, std::sqrt(candidate), q, leaf.triangle[i]};
    }
  }
};

struct RaySearch {
  const MeshCollider& mesh;
  Ray ray;
  RayHit hit{};

  void visit(std::uint32_t child) {
    if (BoxTree::isLeaf(child)) return meetLeaf(mesh.tree().leaf(child));
    const BoxNode& node = mesh.tree().node(child);
    double entries[kTreeWidth];
    std::uint32_t order[kTreeWidth];
    int met = 0;
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      if (!meetsBox(ray, mesh.tree().box(child * kTreeWidth + lane), hit.along, entries[lane])) continue;
      int at = met++;
      for (; at > 0 && entries[order[at - 1]] > entries[lane]; --at) order[at] = order[at - 1];
      order[at] = lane;
    }
    for (int i = 0; i < met; ++i) {
      if (entries[order[i]] <= hit.along) visit(node.child[order[i]]);
    }
  }

  void meetLeaf(const LeafBlock& leaf) {
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const RayCrossing crossing = meetTriangle(ray, mesh.mesh().corners(leaf.triangle[i]));
      // A ray through the edge of two triangles only grazes both, and does not pass between them.
      if (!(crossing.meets || crossing.grazes) || crossing.along >= hit.along) continue;
      hit = {true, crossing.along, ray.origin + crossing.along * ray.direction, leaf.triangle[i]};
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

/// Calls take(triangle) for all triangles in boxes within reach of the probe.
template <typename Take>
void collect(const BoxTree& tree, std::uint32_t child, const Probe& probe, double squared, const Take& take) {
  if (BoxTree::isLeaf(child)) {
    const LeafBlock& leaf = tree.leaf(child);
    for (std::uint32_t i = 0; i < leaf.count; ++i) take(leaf.triangle[i]);
    return;
  }
  openNearestFirst(
      tree.node(child), probe, [squared] { return squared; },
      [&](std::uint32_t below) { collect(tree, below, probe, squared, take); });
}

/// Calls take(triangle_a, triangle_b, nearest) for every pair of triangles within the radius; take returns false to
/// stop. Where it has wanted(triangle_a, triangle_b), only such pairs are measured, until isOver(). A visitor of
/// DualTraversal.
template <typename Take>
struct PairCollector {
  const geometry::TriangleMesh& mesh_a;
  const geometry::TriangleMesh& mesh_b;
  dmat3 R_AB;
  dvec3 p_AB;
  double squared;
  const Take& take;
  bool stopped = false;

  float limitSquared() const { return std::nextafter(static_cast<float>(squared), 1e30f); }
  bool isDone() const { return stopped; }

  void leafPair(const TraversalBox&, const TraversalBox&, const LeafBlock& leaf_a, const LeafBlock& leaf_b,
                const LeafTransform& transform) {
    alignas(16) float ignored[9][kLeafSize];
    const std::uint32_t near = proximityKernels().leafPairs(leaf_a, leaf_b, transform, limitSquared(), ignored);
    for (std::uint32_t j = 0; j < leaf_b.count; ++j) {
      if ((near >> (kLeafSize * j) & 0xFu) == 0) continue;
      const Corners corners_b = transformedCorners(R_AB, p_AB, mesh_b.corners(leaf_b.triangle[j]));
      for (std::uint32_t i = 0; i < leaf_a.count; ++i) {
        if ((near >> (kLeafSize * j + i) & 1u) == 0) continue;
        measure(leaf_a.triangle[i], leaf_b.triangle[j], corners_b);
        if (stopped) return;
      }
    }
  }

  void measure(std::uint32_t a, std::uint32_t b, const Corners& corners_b) {
    if constexpr (requires { take.wanted(a, b); }) {
      if (!take.wanted(a, b)) return;
      if (take.isOver()) {
        stopped = true;
        return;
      }
    }
    NearestPair nearest;
    nearest.squared = std::nextafter(squared, std::numeric_limits<double>::infinity());
    if (improveTriangleDistance(mesh_a.corners(a), corners_b, nearest)) stopped = !take(a, b, nearest);
  }
};

template <typename Take>
bool collectPairs(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius, const Take& take) {
  if (a.isEmpty() || b.isEmpty()) return true;
  const double reach = std::max(radius, kTouchingDistance);
  PairCollector<Take> collector{a.mesh(), b.mesh(), X_AB.R(), X_AB.p, reach * reach, take};
  DualTraversal<PairCollector<Take>>(a.tree(), b.tree(), X_AB, collector).run();
  return !collector.stopped;
}

}  // namespace

NearestPoint nearestPoint(const MeshCollider& mesh, const dvec3& p_MP, double limit) {
  if (mesh.isEmpty()) return {};
  PointSearch search{mesh, {{dmat3(1.0), p_MP, dvec3(0.0)}}, p_MP, limit * limit};
  search.visit(mesh.tree().child(BoxTree::kRoot));
  return search.nearest;
}

RayHit castRay(const MeshCollider& mesh, const dvec3& p_MO, const dvec3& direction_M) {
  if (mesh.isEmpty() || !(glm::dot(direction_M, direction_M) > 0.0)) return {};
  RaySearch search{mesh, {p_MO, direction_M}};
  double entry = 0.0;
  if (meetsBox(search.ray, mesh.tree().box(BoxTree::kRoot), search.hit.along, entry)) {
    search.visit(mesh.tree().child(BoxTree::kRoot));
  }
  return search.hit;
}

void trianglesWithin(const MeshCollider& mesh, const dvec3& p_MP, double radius, std::vector<std::uint32_t>& found) {
  if (mesh.isEmpty()) return;
  const BoxTree& tree = mesh.tree();
  collect(tree, tree.child(BoxTree::kRoot), {{dmat3(1.0), p_MP, dvec3(0.0)}}, radius * radius,
          [&](std::uint32_t triangle) {
            const dvec3 q = closestPointOnTriangle(mesh.mesh().corners(triangle), p_MP);
            if (glm::distance(q, p_MP) <= radius) found.push_back(triangle);
          });
}

void trianglesWithin(const MeshCollider& mesh, const geometry::Bounds& box_M, double radius,
                     std::vector<std::uint32_t>& found) {
  if (mesh.isEmpty() || box_M.isEmpty()) return;
  const BoxTree& tree = mesh.tree();
  collect(tree, tree.child(BoxTree::kRoot), {boxOf(box_M)}, radius * radius, [&](std::uint32_t triangle) {
    if (squaredDistance(mesh.mesh().corners(triangle), box_M) <= radius * radius) found.push_back(triangle);
  });
}

void trianglesWithin(const MeshCollider& b, const MeshCollider& a, const Pose& X_BA, double radius,
                     std::vector<std::uint32_t>& found_in_b) {
  const std::size_t before = found_in_b.size();
  collectPairs(b, a, X_BA, radius, [&](std::uint32_t triangle_b, std::uint32_t, const NearestPair&) {
    found_in_b.push_back(triangle_b);
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
  mutable std::vector<bool> known{};                     ///< By at(), or where that would be too large
  mutable std::unordered_set<std::size_t> known_ones{};  ///< those that are.
  mutable std::size_t looked = 0;

  // Bits, 2 MB: more pairs of labels are kept in a set. Half: 1 MB, slower for large meshes; twice: 4 MB to clear for
  // each search.
  static constexpr std::size_t kMostKnown = std::size_t{1} << 24;
  void begin() {
    const std::size_t all = std::size_t{a.labels} * b.labels;
    if (all <= kMostKnown) known.resize(all);
  }
  bool isKnown(std::size_t pair) const { return known.empty() ? known_ones.count(pair) != 0 : known[pair]; }
  void note(std::size_t pair) const {
    if (known.empty()) {
      known_ones.insert(pair);
    } else {
      known[pair] = true;
    }
  }

  std::size_t at(std::uint32_t triangle_a, std::uint32_t triangle_b) const {
    return std::size_t{b.labels} * a.label_of[triangle_a] + b.label_of[triangle_b];
  }
  bool wanted(std::uint32_t triangle_a, std::uint32_t triangle_b) const {
    // Looks that count as one test: finding that a pair is known is so much cheaper. Half: the budget ends sooner among
    // known pairs; twice: searches of up to twice the time.
    constexpr std::size_t kLooksPerTest = 16;
    if (++looked % kLooksPerTest == 0 && budget.tests > 0) --budget.tests;
    return budget.tests == 0 || !isKnown(at(triangle_a, triangle_b));
  }
  bool isOver() const { return budget.tests == 0 || --budget.tests == 0; }
  bool operator()(std::uint32_t triangle_a, std::uint32_t triangle_b, const NearestPair&) const {
    if (found.size() >= budget.pairs) return false;
    note(at(triangle_a, triangle_b));
    found.push_back({a.label_of[triangle_a], b.label_of[triangle_b]});
    return true;
  }
};

}  // namespace

bool labelPairsWithin(const LabelledMesh& a, const LabelledMesh& b, const Pose& X_AB, double radius,
                      SearchBudget& budget, std::vector<LabelPair>& found) {
  found.clear();
  LabelCollector collector{a, b, budget, found};
  collector.begin();
  if (a.mesh.isEmpty() || b.mesh.isEmpty()) return true;
  return collectPairs(a.mesh, b.mesh, X_AB, radius, collector);
}

bool trianglePairsWithin(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double radius,
                         std::vector<TrianglePair>& found, std::size_t maximum) {
  return collectPairs(a, b, X_AB, radius,
                      [&](std::uint32_t triangle_a, std::uint32_t triangle_b, const NearestPair& pair) {
                        if (found.size() >= maximum) return false;
                        found.push_back({triangle_a, triangle_b, std::sqrt(pair.squared), pair.p, pair.q});
                        return true;
                      });
}

}  // namespace hapticell::collision
