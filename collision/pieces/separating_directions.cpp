// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/separating_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "collision/pieces/gauss_grid.h"

namespace hapticell::collision {
namespace {

constexpr std::uint32_t kObstacleFeature = 0x80000000u;
constexpr std::uint32_t kBeyondFeature = 0x10000000u;
constexpr std::uint32_t kEdgeFeature = 0x40000000u;
/// Pairs of edges tested one by one, some ns each; with more, those whose arcs cross are looked up in a GaussGrid. Half
/// and twice change only time.
constexpr std::size_t kFewEdgePairs = 20000;
/// m: points and planes that are as high but for rounding (1e-15 at a metre, some operations). Half and twice stand as
/// far from it.
constexpr double kEqualHeight = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Extreme {
  double value = 0.0;
  std::uint32_t vertex = 0;
};

geometry::Bounds grownBox(geometry::Bounds bounds, double by) {
  bounds.min -= dvec3(by);
  bounds.max += dvec3(by);
  return bounds;
}

bool contains(const geometry::Bounds& box, const dvec3& p) {
  return glm::all(glm::greaterThanEqual(p, box.min)) && glm::all(glm::lessThanEqual(p, box.max));
}

bool meets(const geometry::Bounds& box, const dvec3& a, const dvec3& b) {
  return glm::all(glm::greaterThanEqual(glm::max(a, b), box.min)) &&
         glm::all(glm::lessThanEqual(glm::min(a, b), box.max));
}

/// The lowest of the points along nhat; of equal ones the first that lies in `near`. Ends early below `floor`.
Extreme lowest(const std::vector<dvec3>& points, const dvec3& nhat, const geometry::Bounds& near, double floor) {
  Extreme best{kInfinity, 0};
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (const double value = glm::dot(nhat, points[i]); value < best.value) {
      best = {value, i};
      if (value < floor) return best;
    }
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (glm::dot(nhat, points[i]) <= best.value + kEqualHeight && contains(near, points[i])) return {best.value, i};
  }
  return best;
}

double highest(const std::vector<dvec3>& points, const dvec3& nhat) {
  double best = -kInfinity;
  for (const dvec3& p : points) best = std::max(best, glm::dot(nhat, p));
  return best;
}

/// The part of the segment from p to q that lies in the box, as fractions; empty where the first is not below the
/// second.
std::pair<double, double> clipped(const geometry::Bounds& box, const dvec3& p, const dvec3& q) {
  double enter = 0.0;
  double leave = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double along = q[k] - p[k];
    const double low = box.min[k] - p[k];
    const double high = box.max[k] - p[k];
    if (along == 0.0) {
      if (low > 0.0 || high < 0.0) return {1.0, 0.0};
      continue;
    }
    enter = std::max(enter, std::min(low / along, high / along));
    leave = std::min(leave, std::max(low / along, high / along));
  }
  return {enter, leave};
}

/// Calls back with the planes or edges whose block comes near a box in the world.
template <typename Callback>
void forNear(const PlacedPiece& piece, const std::vector<FeatureBlock>& blocks, const geometry::Bounds& near_W,
             Callback&& callback) {
  const bool all = blocks.size() <= 1;
  const geometry::Bounds near_M = all ? geometry::Bounds{} : geometry::transformed(piece.X_MW, near_W);
  for (const FeatureBlock& block : blocks) {
    if (!all && !meets(near_M, block.bounds.min, block.bounds.max)) continue;
    for (std::uint32_t i = block.first; i < block.end; ++i) callback(i);
  }
}

bool isInsideHull(const dvec3& p_W, const PlacedPiece& piece) {
  return std::all_of(piece.planes_W.begin(), piece.planes_W.end(),
                     [&](const HullPlane& plane) { return glm::dot(plane.nhat, p_W) < plane.offset; });
}

/// Collects the support points of one side's corners that turning could bring up.
class SupportCollector {
 public:
  SupportCollector(const PlacedPiece& piece, const SeparatingDirection& direction, double max_rotation)
      : piece_(piece), direction_(direction), max_rotation_(max_rotation) {}

  /// Points of the moving piece over the obstacle's plane, or of the obstacle under the moving piece's plane.
  void collect(const geometry::Bounds& near, bool of_moving, std::vector<SupportPoint>& supports) {
    of_moving_ = of_moving;
    std::vector<std::uint32_t> corners;
    forNear(piece_, piece_.piece->edge_blocks, near, [&](std::uint32_t i) {
      const auto& v = piece_.piece->hull.edges[i].vertices;
      const dvec3& p = piece_.vertices_W[v[0]];
      const dvec3& q = piece_.vertices_W[v[1]];
      const auto [enter, leave] = clipped(near, p, q);
      if (enter >= leave) return;
      // Where an edge leaves the neighbourhood its end stands for the corner that is too far away to be met.
      enter > 0.0 ? consider(p + enter * (q - p), kEdgeFeature + 2 * i, supports) : corners.push_back(v[0]);
      leave < 1.0 ? consider(p + leave * (q - p), kEdgeFeature + 2 * i + 1, supports) : corners.push_back(v[1]);
    });
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const auto vertex : corners) consider(piece_.vertices_W[vertex], vertex, supports);
  }

 private:
  void consider(const dvec3& p, std::uint32_t feature, std::vector<SupportPoint>& supports) const {
    const SupportPoint& first = direction_.support;
    const dvec3& n = direction_.nhat_W;
    const dvec3& on_plane = first.normal_moves == of_moving_ ? first.p_W : first.q_W;
    const double gap = of_moving_ ? glm::dot(n, p - on_plane) : glm::dot(n, on_plane - p);
    if (gap - first.gap > max_rotation_ * glm::length(p - first.p_W) + kEqualHeight) return;
    const std::uint32_t own = of_moving_ ? feature : kObstacleFeature + feature;
    if (own == first.feature) return;
    supports.push_back({p, of_moving_ ? p - gap * n : p + gap * n, gap, !of_moving_, own});
  }

  const PlacedPiece& piece_;
  const SeparatingDirection& direction_;
  double max_rotation_;
  bool of_moving_ = true;
};

class DirectionFinder {
 public:
  DirectionFinder(const PlacedPiece& moving, const PlacedPiece& obstacle, const DirectionLimits& limits)
      : a_(moving),
        b_(obstacle),
        limits_(limits),
        near_a_(grownBox(moving.bounds_W, limits.reach)),
        near_b_(grownBox(obstacle.bounds_W, limits.reach)) {}

  std::vector<SeparatingDirection> run() {
    const auto rank = [](const PlacedPiece& piece, std::uint32_t plane) {
      return piece.piece->real_plane[plane] != 0 ? DirectionRank::kFace : DirectionRank::kVirtual;
    };
    forNear(b_, b_.piece->plane_blocks, near_a_,
            [&](std::uint32_t i) { addObstacleFace(b_.planes_W[i].nhat, b_.planes_W[i].offset, rank(b_, i), i); });
    forNear(a_, a_.piece->plane_blocks, near_b_,
            [&](std::uint32_t i) { addMovingFace(a_.planes_W[i].nhat, a_.planes_W[i].offset, rank(a_, i), i); });
    addEdgePairs();
    if (found_.empty()) return {};
    for (std::uint32_t i = 0; i < b_.beyond_W.size(); ++i) {
      addObstacleFace(b_.beyond_W[i], highest(b_.vertices_W, b_.beyond_W[i]), DirectionRank::kBeyond,
                      kBeyondFeature + i);
    }
    for (std::uint32_t i = 0; i < a_.beyond_W.size(); ++i) {
      addMovingFace(a_.beyond_W[i], highest(a_.vertices_W, a_.beyond_W[i]), DirectionRank::kBeyond, kBeyondFeature + i);
    }
    joinEqual();
    return std::move(found_);
  }

 private:
  void addObstacleFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature);
  void addMovingFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature);
  void addEdgePairs();
  void addEdgePair(const HullEdge& edge_a, const HullEdge& edge_b, std::uint32_t index_a, std::uint32_t index_b);
  /// Sorts by gap and makes one of directions that are equal.
  void joinEqual();

  const PlacedPiece& a_;
  const PlacedPiece& b_;
  DirectionLimits limits_;
  geometry::Bounds near_a_, near_b_;
  std::vector<SeparatingDirection> found_;
};

void DirectionFinder::joinEqual() {
  std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.gap > b.gap; });
  std::vector<SeparatingDirection> kept;
  for (SeparatingDirection& direction : found_) {
    bool known = false;
    for (std::size_t i = kept.size(); i-- > 0 && kept[i].gap - direction.gap <= kEqualHeight;) {
      if (glm::dot(kept[i].nhat_W, direction.nhat_W) < 1.0 - 1e-12) continue;
      if (direction.rank < kept[i].rank) std::swap(kept[i], direction);
      if (direction.on_obstacle_face && !kept[i].on_obstacle_face) kept[i].feature_B = direction.feature_B;
      kept[i].on_obstacle_face = kept[i].on_obstacle_face || direction.on_obstacle_face;
      kept[i].on_moving_face = kept[i].on_moving_face || direction.on_moving_face;
      known = true;
      break;
    }
    if (!known) kept.push_back(std::move(direction));
  }
  found_ = std::move(kept);
}

void DirectionFinder::addObstacleFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature) {
  const Extreme support = lowest(a_.vertices_W, nhat, near_b_, offset - limits_.reach);
  const double gap = support.value - offset;
  if (gap < -limits_.reach) return;
  SeparatingDirection direction{nhat, gap, rank, support.vertex, feature};
  direction.on_obstacle_face = true;
  const dvec3& p = a_.vertices_W[support.vertex];
  direction.support = {p, p - gap * nhat, gap, false, support.vertex};
  found_.push_back(std::move(direction));
}

void DirectionFinder::addMovingFace(const dvec3& outward, double offset, DirectionRank rank, std::uint32_t feature) {
  const Extreme support = lowest(b_.vertices_W, outward, near_a_, offset - limits_.reach);
  const double gap = support.value - offset;
  if (gap < -limits_.reach) return;
  SeparatingDirection direction{-outward, gap, rank, feature, support.vertex};
  direction.on_moving_face = true;
  const dvec3& p = b_.vertices_W[support.vertex];
  direction.support = {p, p - gap * outward, gap, true, kObstacleFeature + support.vertex};
  found_.push_back(std::move(direction));
}

void DirectionFinder::addEdgePairs() {
  const auto nearEdges = [](const PlacedPiece& piece, const geometry::Bounds& near) {
    std::vector<std::uint32_t> edges;
    forNear(piece, piece.piece->edge_blocks, near, [&](std::uint32_t i) {
      const auto& v = piece.piece->hull.edges[i].vertices;
      if (meets(near, piece.vertices_W[v[0]], piece.vertices_W[v[1]])) edges.push_back(i);
    });
    return edges;
  };
  const auto edges_a = nearEdges(a_, near_b_);
  if (edges_a.empty()) return;
  const auto edges_b = nearEdges(b_, near_a_);
  const auto& hull_a = a_.piece->hull.edges;
  const auto& hull_b = b_.piece->hull.edges;
  if (edges_a.size() * edges_b.size() <= kFewEdgePairs) {
    for (const auto i : edges_a) {
      for (const auto j : edges_b) addEdgePair(hull_a[i], hull_b[j], i, j);
    }
    return;
  }
  GaussGrid grid;
  for (const auto j : edges_b) grid.add(b_.planes_W[hull_b[j].planes[0]].nhat, b_.planes_W[hull_b[j].planes[1]].nhat);
  std::vector<std::uint32_t> crossing;
  for (const auto i : edges_a) {
    grid.crossing(-a_.planes_W[hull_a[i].planes[0]].nhat, -a_.planes_W[hull_a[i].planes[1]].nhat, crossing);
    for (const auto k : crossing) addEdgePair(hull_a[i], hull_b[edges_b[k]], i, edges_b[k]);
  }
}

void DirectionFinder::addEdgePair(const HullEdge& edge_a, const HullEdge& edge_b, std::uint32_t index_a,
                                  std::uint32_t index_b) {
  const dvec3& b0 = b_.planes_W[edge_b.planes[0]].nhat;
  const dvec3& b1 = b_.planes_W[edge_b.planes[1]].nhat;
  const dvec3 a0 = -a_.planes_W[edge_a.planes[0]].nhat;
  const dvec3 a1 = -a_.planes_W[edge_a.planes[1]].nhat;
  const dvec3& pa = a_.vertices_W[edge_a.vertices[0]];
  const dvec3& pb = b_.vertices_W[edge_b.vertices[0]];
  const dvec3 ea = a_.vertices_W[edge_a.vertices[1]] - pa;
  const dvec3 eb = b_.vertices_W[edge_b.vertices[1]] - pb;
  const double a0_eb = glm::dot(a0, eb), a1_eb = glm::dot(a1, eb);
  const double b0_ea = glm::dot(b0, ea), b1_ea = glm::dot(b1, ea);
  if (a0_eb * a1_eb >= 0.0 || b0_ea * b1_ea >= 0.0) return;
  dvec3 nhat = glm::cross(ea, eb);
  const double sine = glm::length(nhat) / (glm::length(ea) * glm::length(eb));
  if (sine < 1e-6) return;
  nhat = glm::normalize(nhat);
  if (glm::dot(nhat, b0 + b1) < 0.0) nhat = -nhat;
  if (glm::dot(nhat, a0 + a1) <= 0.0) return;
  const double gap = glm::dot(nhat, pa - pb);
  if (gap < -limits_.reach) return;
  const dvec3 w = pa - pb;
  const double aa = glm::dot(ea, ea), bb = glm::dot(eb, eb), ab = glm::dot(ea, eb);
  const double wa = glm::dot(w, ea), wb = glm::dot(w, eb);
  const double s = std::clamp((ab * wb - bb * wa) / (aa * bb - ab * ab), -1.0, 2.0);
  const dvec3 p = pa + s * ea;
  const auto real = [](const PlacedPiece& piece, const HullEdge& edge) {
    return piece.piece->real_plane[edge.planes[0]] != 0 && piece.piece->real_plane[edge.planes[1]] != 0;
  };
  const DirectionRank rank = real(a_, edge_a) && real(b_, edge_b) ? DirectionRank::kFace : DirectionRank::kVirtual;
  SeparatingDirection direction{nhat, gap, rank, kEdgeFeature + index_a, kEdgeFeature + index_b};
  direction.support = {p, p - gap * nhat, gap, false, kEdgeFeature + index_a};
  found_.push_back(std::move(direction));
}

}  // namespace

void completeSupports(SeparatingDirection& direction, const PlacedPiece& moving, const PlacedPiece& obstacle,
                      const DirectionLimits& limits) {
  direction.supports = {direction.support};
  if (direction.on_obstacle_face) {
    SupportCollector(moving, direction, limits.max_rotation)
        .collect(grownBox(obstacle.bounds_W, limits.reach), true, direction.supports);
  }
  if (direction.on_moving_face) {
    SupportCollector(obstacle, direction, limits.max_rotation)
        .collect(grownBox(moving.bounds_W, limits.reach), false, direction.supports);
  }
  thinOut(direction.supports, limits.max_supports);
}

void thinOut(std::vector<SupportPoint>& supports, std::size_t count) {
  if (supports.size() <= count) return;
  std::vector<double> apart(supports.size(), kInfinity);
  std::size_t newest = 0;
  for (std::size_t kept = 1; kept < count; ++kept) {
    std::size_t best = kept;
    for (std::size_t i = kept; i < supports.size(); ++i) {
      apart[i] = std::min(apart[i], glm::length(supports[i].p_W - supports[newest].p_W));
      if (apart[i] > apart[best] * (1.0 + 1e-9)) best = i;
    }
    std::swap(supports[kept], supports[best]);
    std::swap(apart[kept], apart[best]);
    newest = kept;
  }
  supports.resize(count);
}

PlacedPiece placed(const ConvexPiece& piece, const Pose& X_W) {
  PlacedPiece result;
  result.piece = &piece;
  result.X_MW = X_W.inverse();
  const dmat3 R = X_W.R();
  for (const dvec3& p : piece.hull.vertices) result.vertices_W.push_back(R * p + X_W.p);
  for (const HullPlane& plane : piece.hull.planes) {
    const dvec3 nhat = R * plane.nhat;
    result.planes_W.push_back({nhat, plane.offset + glm::dot(nhat, X_W.p)});
  }
  for (const dvec3& nhat : piece.beyond_edges) result.beyond_W.push_back(R * nhat);
  result.bounds_W = geometry::boundsOf(result.vertices_W);
  return result;
}

bool mayMeet(const PlacedPiece& moving, const PlacedPiece& obstacle, double reach) {
  const auto hasNear = [](const PlacedPiece& piece, const geometry::Bounds& near_W) {
    if (piece.piece->plane_blocks.size() <= 1) return true;
    const geometry::Bounds near_M = geometry::transformed(piece.X_MW, near_W);
    return std::any_of(piece.piece->plane_blocks.begin(), piece.piece->plane_blocks.end(),
                       [&](const FeatureBlock& block) { return meets(near_M, block.bounds.min, block.bounds.max); });
  };
  if (hasNear(moving, grownBox(obstacle.bounds_W, reach)) && hasNear(obstacle, grownBox(moving.bounds_W, reach)))
    return true;
  return isInside(moving, obstacle);
}

SeparatingDirection nearestDirection(const PlacedPiece& moving, const PlacedPiece& obstacle, double enough) {
  // Steps towards the nearest direction; each raises a lower bound of the gap, so an early end is safe. Half: some
  // pairs seem nearer than they are; twice: seldom used up.
  constexpr int kIterations = 24;
  const geometry::Bounds nowhere;
  SeparatingDirection best;
  best.gap = -kInfinity;
  best.rank = DirectionRank::kVirtual;
  const dvec3 middle = obstacle.bounds_W.center();
  dvec3 v = moving.vertices_W.front() - middle;
  for (const dvec3& p : moving.vertices_W) {
    if (glm::dot(p - middle, p - middle) < glm::dot(v, v)) v = p - middle;
  }
  for (int i = 0; i < kIterations; ++i) {
    const double length = glm::length(v);
    if (length < 1e-12) break;
    const dvec3 nhat = v / length;
    const Extreme low = lowest(moving.vertices_W, nhat, nowhere, -kInfinity);
    const Extreme high = lowest(obstacle.vertices_W, -nhat, nowhere, -kInfinity);
    const dvec3& p = moving.vertices_W[low.vertex];
    const double gap = low.value + high.value;
    if (gap > best.gap) {
      best.nhat_W = nhat;
      best.gap = gap;
      best.feature_A = low.vertex;
      best.feature_B = high.vertex;
      best.support = {p, p - gap * nhat, gap, false, low.vertex};
    }
    if (best.gap > enough || length - gap < 0.02 * length) break;
    const dvec3 w = p - obstacle.vertices_W[high.vertex];
    const dvec3 step = w - v;
    v += std::clamp(-glm::dot(v, step) / glm::dot(step, step), 0.0, 1.0) * step;
  }
  return best;
}

bool isInside(const PlacedPiece& moving, const PlacedPiece& obstacle) {
  return isInsideHull(moving.bounds_W.center(), obstacle) || isInsideHull(obstacle.bounds_W.center(), moving) ||
         isInsideHull(moving.vertices_W.front(), obstacle) || isInsideHull(obstacle.vertices_W.front(), moving);
}

std::vector<SeparatingDirection> separatingDirections(const PlacedPiece& moving, const PlacedPiece& obstacle,
                                                      const DirectionLimits& limits) {
  return DirectionFinder(moving, obstacle, limits).run();
}

}  // namespace hapticell::collision
