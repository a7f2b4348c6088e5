// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace hapticell::collision {
namespace {

struct Facet {
  std::array<std::uint32_t, 3> corners{};
  HullPlane plane;
  std::vector<std::uint32_t> outside;
  bool alive = true;
};

class QuickHull {
 public:
  QuickHull(std::span<const dvec3> points, double tolerance) : points_(points), tolerance_(tolerance) {}

  bool run() {
    if (!makeFirstTetrahedron()) return false;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      while (facets_[i].alive && !facets_[i].outside.empty()) {
        if (facets_.size() > kMostFacets || !addPoint(farthestOutside(facets_[i]))) return false;
      }
    }
    return true;
  }

  ConvexHull result() const;

 private:
  // Facets made, dead ones too, until the hull is given up: a piece has some hundred. It bounds time and memory for
  // hostile points; half and twice change that bound only.
  static constexpr std::size_t kMostFacets = 200000;

  double height(const Facet& facet, std::uint32_t point) const {
    return glm::dot(facet.plane.nhat, points_[point]) - facet.plane.offset;
  }

  std::uint32_t farthestOutside(const Facet& facet) const {
    return *std::max_element(facet.outside.begin(), facet.outside.end(),
                             [&](auto a, auto b) { return height(facet, a) < height(facet, b); });
  }

  bool addFacet(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const dvec3 normal = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
    const double length = glm::length(normal);
    if (length <= 1e-30) return false;
    Facet facet;
    facet.corners = {a, b, c};
    facet.plane.nhat = normal / length;
    facet.plane.offset = glm::dot(facet.plane.nhat, points_[a]);
    alive_.push_back(static_cast<std::uint32_t>(facets_.size()));
    facets_.push_back(std::move(facet));
    return true;
  }

  bool makeFirstTetrahedron();
  bool addPoint(std::uint32_t point);
  void hand(std::span<const std::uint32_t> loose, std::size_t first_facet, std::uint32_t skip);

  std::span<const dvec3> points_;
  double tolerance_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> alive_;
};

bool QuickHull::makeFirstTetrahedron() {
  if (points_.size() < 4) return false;
  std::array<std::uint32_t, 4> corner{};
  const auto count = static_cast<std::uint32_t>(points_.size());
  const auto farthest = [&](auto&& measure) {
    std::uint32_t best = 0;
    double most = -1.0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (const double value = measure(points_[i]); value > most) {
        most = value;
        best = i;
      }
    }
    return std::pair(best, most);
  };
  corner[0] = farthest([&](const dvec3& p) { return glm::length(p - points_[0]); }).first;
  const dvec3 a = points_[corner[0]];
  const auto [second, spread] = farthest([&](const dvec3& p) { return glm::length(p - a); });
  if (spread <= tolerance_) return false;
  corner[1] = second;
  const dvec3 along = (points_[second] - a) / spread;
  const auto [third, width] = farthest([&](const dvec3& p) { return glm::length(glm::cross(p - a, along)); });
  if (width <= tolerance_) return false;
  corner[2] = third;
  const dvec3 normal = glm::normalize(glm::cross(along, points_[third] - a));
  const auto [fourth, thickness] = farthest([&](const dvec3& p) { return std::abs(glm::dot(p - a, normal)); });
  if (thickness <= tolerance_) return false;
  corner[3] = fourth;
  if (glm::dot(points_[fourth] - a, normal) > 0.0) std::swap(corner[1], corner[2]);
  if (!addFacet(corner[0], corner[1], corner[2]) || !addFacet(corner[0], corner[3], corner[1]) ||
      !addFacet(corner[1], corner[3], corner[2]) || !addFacet(corner[2], corner[3], corner[0])) {
    return false;
  }
  std::vector<std::uint32_t> loose(count);
  for (std::uint32_t i = 0; i < count; ++i) loose[i] = i;
  hand(loose, 0, count);
  return true;
}

void QuickHull::hand(std::span<const std::uint32_t> loose, std::size_t first_facet, std::uint32_t skip) {
  for (const std::uint32_t point : loose) {
    if (point == skip) continue;
    double most = tolerance_;
    std::size_t best = facets_.size();
    for (std::size_t i = first_facet; i < facets_.size(); ++i) {
      if (!facets_[i].alive) continue;
      if (const double value = height(facets_[i], point); value > most) {
        most = value;
        best = i;
      }
    }
    if (best < facets_.size()) facets_[best].outside.push_back(point);
  }
}

bool QuickHull::addPoint(std::uint32_t point) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> rim;
  std::vector<std::uint32_t> loose;
  std::vector<std::uint32_t> alive;
  for (const std::uint32_t index : alive_) {
    Facet& facet = facets_[index];
    if (height(facet, point) <= 0.5 * tolerance_) {
      alive.push_back(index);
      continue;
    }
    facet.alive = false;
    loose.insert(loose.end(), facet.outside.begin(), facet.outside.end());
    facet.outside.clear();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = facet.corners[k];
      const auto to = facet.corners[(k + 1) % 3];
      if (rim.erase({to, from}) == 0) rim[{from, to}] = 1;
    }
  }
  alive_ = std::move(alive);
  const std::size_t first_facet = facets_.size();
  for (const auto& [edge, unused] : rim) {
    if (!addFacet(edge.first, edge.second, point)) return false;
  }
  hand(loose, first_facet, point);
  return true;
}

ConvexHull QuickHull::result() const {
  ConvexHull hull;
  std::map<std::uint32_t, std::uint32_t> vertex_of;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> plane_of_edge;
  // Of 1 - cos: 0.0026 deg, the angle by which rounding in STL (6e-8 of the size) tilts an edge of a thousandth of it.
  // Half: such faces fall apart; twice: the same, as how far corners are off is checked too.
  constexpr double kCoplanar = 1e-9;
  std::vector<std::pair<double, const Facet*>> by_area;
  for (const Facet& facet : facets_) {
    if (!facet.alive) continue;
    const auto& c = facet.corners;
    by_area.emplace_back(-glm::length(glm::cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]])),
                         &facet);
  }
  std::stable_sort(by_area.begin(), by_area.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [area, facet] : by_area) {
    std::uint32_t plane = 0;
    for (; plane < hull.planes.size(); ++plane) {
      const HullPlane& known = hull.planes[plane];
      double off = 0.0;
      for (const auto corner : facet->corners) {
        off = std::max(off, std::abs(glm::dot(known.nhat, points_[corner]) - known.offset));
      }
      if (off <= 4.0 * tolerance_ && glm::dot(known.nhat, facet->plane.nhat) > 0.0) break;
      if (1.0 - glm::dot(known.nhat, facet->plane.nhat) < kCoplanar && off <= 40.0 * tolerance_) break;
    }
    if (plane == hull.planes.size()) hull.planes.push_back(facet->plane);
    for (std::size_t k = 0; k < 3; ++k) {
      vertex_of.emplace(facet->corners[k], 0);
      plane_of_edge[{facet->corners[k], facet->corners[(k + 1) % 3]}] = plane;
    }
  }
  for (auto& [point, vertex] : vertex_of) {
    vertex = static_cast<std::uint32_t>(hull.vertices.size());
    hull.vertices.push_back(points_[point]);
  }
  for (const auto& [edge, plane] : plane_of_edge) {
    if (edge.first > edge.second) continue;
    const auto other = plane_of_edge.find({edge.second, edge.first});
    if (other == plane_of_edge.end() || other->second == plane) continue;
    hull.edges.push_back({{vertex_of[edge.first], vertex_of[edge.second]}, {plane, other->second}});
  }
  for (HullPlane& plane : hull.planes) {
    for (const dvec3& p : hull.vertices) plane.offset = std::max(plane.offset, glm::dot(plane.nhat, p));
  }
  return hull;
}

/// The corners of the hull in counter-clockwise order, none on a straight line between others.
std::vector<glm::dvec2> planarHull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto turnsLeft = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 ab = b - a;
    const glm::dvec2 bc = c - b;
    return ab.x * bc.y - ab.y * bc.x > 1e-12 * glm::length(ab) * glm::length(bc);
  };
  std::vector<glm::dvec2> rim;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = rim.size();
    for (const glm::dvec2& p : points) {
      while (rim.size() >= first + 2 && !turnsLeft(rim[rim.size() - 2], rim.back(), p)) rim.pop_back();
      rim.push_back(p);
    }
    rim.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return rim;
}

}  // namespace

std::optional<ConvexHull> convexHull(std::span<const dvec3> points, double tolerance) {
  QuickHull quick(points, tolerance);
  if (!quick.run()) return std::nullopt;
  ConvexHull hull = quick.result();
  if (hull.planes.size() < 4) return std::nullopt;
  for (const HullPlane& plane : hull.planes) {
    for (const dvec3& point : points) {
      if (glm::dot(plane.nhat, point) > plane.offset + 8.0 * tolerance) return std::nullopt;
    }
  }
  return hull;
}

std::optional<ConvexHull> convexPrism(std::span<const dvec3> points, const dvec3& nhat, double thickness) {
  const dvec3 u = glm::normalize(glm::cross(nhat, std::abs(nhat.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  const dvec3 v = glm::cross(nhat, u);
  std::vector<glm::dvec2> flat;
  double front = -std::numeric_limits<double>::infinity();
  for (const dvec3& p : points) {
    flat.emplace_back(glm::dot(u, p), glm::dot(v, p));
    front = std::max(front, glm::dot(nhat, p));
  }
  const std::vector<glm::dvec2> rim = planarHull(std::move(flat));
  const auto count = static_cast<std::uint32_t>(rim.size());
  if (count < 3) return std::nullopt;
  ConvexHull hull;
  hull.planes = {{nhat, front}, {-nhat, thickness - front}};
  for (const double height : {front, front - thickness}) {
    for (const glm::dvec2& p : rim) hull.vertices.push_back(p.x * u + p.y * v + height * nhat);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    const dvec3 side = glm::normalize(glm::cross(hull.vertices[next] - hull.vertices[i], nhat));
    hull.planes.push_back({side, std::max(glm::dot(side, hull.vertices[i]), glm::dot(side, hull.vertices[next]))});
    hull.edges.push_back({{i, next}, {0, 2 + i}});
    hull.edges.push_back({{count + i, count + next}, {1, 2 + i}});
    hull.edges.push_back({{next, count + next}, {2 + i, 2 + next}});
  }
  return hull;
}

}  // namespace hapticell::collision
