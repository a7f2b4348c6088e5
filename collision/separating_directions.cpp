// SPDX-License-Identifier: Apache-2.0
#include "collision/separating_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hapticell::collision {
namespace {

constexpr std::uint32_t kObstacleFeature = 0x80000000u;
constexpr std::uint32_t kEdgeFeature = 0x40000000u;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Extreme {
  double value = 0.0;
  std::uint32_t vertex = 0;
};

Extreme lowest(const std::vector<dvec3>& points, const dvec3& nhat) {
  Extreme best{kInfinity, 0};
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (const double value = glm::dot(nhat, points[i]); value < best.value) best = {value, i};
  }
  return best;
}

Extreme highest(const std::vector<dvec3>& points, const dvec3& nhat) {
  const Extreme mirrored = lowest(points, -nhat);
  return {-mirrored.value, mirrored.vertex};
}

geometry::Bounds grown(geometry::Bounds bounds, double by) {
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

/// Keeps the first and of the others those farthest apart, nearest to the face first among equals.
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

class DirectionFinder {
 public:
  DirectionFinder(const PlacedPiece& moving, const PlacedPiece& obstacle, const DirectionLimits& limits)
      : a_(moving),
        b_(obstacle),
        limits_(limits),
        near_a_(grown(moving.bounds_W, limits.reach)),
        near_b_(grown(obstacle.bounds_W, limits.reach)) {}

  std::vector<SeparatingDirection> run() {
    for (std::uint32_t i = 0; i < b_.planes_W.size(); ++i) {
      const bool real = b_.piece->real_plane[i] != 0;
      addObstacleFace(b_.planes_W[i].nhat, b_.planes_W[i].offset, real ? DirectionRank::kFace : DirectionRank::kVirtual,
                      i);
    }
    for (std::uint32_t i = 0; i < b_.beyond_W.size(); ++i) {
      addObstacleFace(b_.beyond_W[i], highest(b_.vertices_W, b_.beyond_W[i]).value, DirectionRank::kBeyond,
                      0x10000000u + i);
    }
    for (std::uint32_t i = 0; i < a_.planes_W.size(); ++i) {
      const bool real = a_.piece->real_plane[i] != 0;
      addMovingFace(a_.planes_W[i].nhat, a_.planes_W[i].offset, real ? DirectionRank::kFace : DirectionRank::kVirtual,
                    i);
    }
    for (std::uint32_t i = 0; i < a_.beyond_W.size(); ++i) {
      addMovingFace(a_.beyond_W[i], highest(a_.vertices_W, a_.beyond_W[i]).value, DirectionRank::kBeyond,
                    0x10000000u + i);
    }
    addEdgePairs();
    return std::move(found_);
  }

 private:
  void addObstacleFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature);
  void addMovingFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature);
  void addEdgePairs();
  void addEdgePair(const HullEdge& edge_a, const HullEdge& edge_b, std::uint32_t index_a, std::uint32_t index_b);
  /// Adds it, or joins it with an equal one found before.
  void add(SeparatingDirection direction);

  const PlacedPiece& a_;
  const PlacedPiece& b_;
  DirectionLimits limits_;
  geometry::Bounds near_a_, near_b_;
  std::vector<SeparatingDirection> found_;
};

void DirectionFinder::add(SeparatingDirection direction) {
  for (SeparatingDirection& known : found_) {
    if (std::abs(known.gap - direction.gap) > 1e-9 || glm::dot(known.nhat_W, direction.nhat_W) < 1.0 - 1e-12) continue;
    known.rank = std::min(known.rank, direction.rank);
    known.supports.insert(known.supports.end(), direction.supports.begin(), direction.supports.end());
    return;
  }
  found_.push_back(std::move(direction));
}

void DirectionFinder::addObstacleFace(const dvec3& nhat, double offset, DirectionRank rank, std::uint32_t feature) {
  const Extreme support = lowest(a_.vertices_W, nhat);
  SeparatingDirection direction{nhat, support.value - offset, rank, support.vertex, feature, {}};
  if (direction.gap < -limits_.reach) return;
  const auto point = [&](std::uint32_t vertex) {
    const dvec3& p = a_.vertices_W[vertex];
    const double gap = glm::dot(nhat, p) - offset;
    return SupportPoint{p, p - gap * nhat, gap, false, vertex};
  };
  direction.supports.push_back(point(support.vertex));
  for (std::uint32_t i = 0; i < a_.vertices_W.size(); ++i) {
    if (i == support.vertex || !contains(near_b_, a_.vertices_W[i])) continue;
    const SupportPoint other = point(i);
    const double lever = glm::length(other.p_W - direction.supports.front().p_W);
    if (other.gap - direction.gap <= limits_.max_rotation * lever + 1e-9) direction.supports.push_back(other);
  }
  thinOut(direction.supports, limits_.max_supports);
  add(std::move(direction));
}

void DirectionFinder::addMovingFace(const dvec3& outward, double offset, DirectionRank rank, std::uint32_t feature) {
  const Extreme support = highest(b_.vertices_W, -outward);
  const dvec3 nhat = -outward;
  SeparatingDirection direction{nhat, -offset - support.value, rank, feature, support.vertex, {}};
  if (direction.gap < -limits_.reach) return;
  const auto point = [&](std::uint32_t vertex) {
    const dvec3& p = b_.vertices_W[vertex];
    const double gap = -offset - glm::dot(nhat, p);
    return SupportPoint{p, p + gap * nhat, gap, true, kObstacleFeature + vertex};
  };
  direction.supports.push_back(point(support.vertex));
  for (std::uint32_t i = 0; i < b_.vertices_W.size(); ++i) {
    if (i == support.vertex || !contains(near_a_, b_.vertices_W[i])) continue;
    const SupportPoint other = point(i);
    const double lever = glm::length(other.p_W - direction.supports.front().p_W);
    if (other.gap - direction.gap <= limits_.max_rotation * lever + 1e-9) direction.supports.push_back(other);
  }
  thinOut(direction.supports, limits_.max_supports);
  add(std::move(direction));
}

void DirectionFinder::addEdgePairs() {
  std::vector<std::uint32_t> edges_b;
  for (std::uint32_t i = 0; i < b_.piece->hull.edges.size(); ++i) {
    const auto& v = b_.piece->hull.edges[i].vertices;
    if (meets(near_a_, b_.vertices_W[v[0]], b_.vertices_W[v[1]])) edges_b.push_back(i);
  }
  if (edges_b.empty()) return;
  for (std::uint32_t i = 0; i < a_.piece->hull.edges.size(); ++i) {
    const HullEdge& edge = a_.piece->hull.edges[i];
    if (!meets(near_b_, a_.vertices_W[edge.vertices[0]], a_.vertices_W[edge.vertices[1]])) continue;
    for (const auto j : edges_b) addEdgePair(edge, b_.piece->hull.edges[j], i, j);
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
  add({nhat,
       gap,
       rank,
       kEdgeFeature + index_a,
       kEdgeFeature + index_b,
       {SupportPoint{p, p - gap * nhat, gap, false, kEdgeFeature + index_a}}});
}

}  // namespace

PlacedPiece placed(const ConvexPiece& piece, const Pose& X_W) {
  PlacedPiece result;
  result.piece = &piece;
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

std::vector<SeparatingDirection> separatingDirections(const PlacedPiece& moving, const PlacedPiece& obstacle,
                                                      const DirectionLimits& limits) {
  return DirectionFinder(moving, obstacle, limits).run();
}

}  // namespace hapticell::collision
