// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hapticell::geometry {

namespace {

double squaredToSegment(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 way = b - a;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
  const dvec3 off = p - a - share * way;
  return glm::dot(off, off);
}

/// From its plane where the point lies over it, else from its edges.
double squaredToTriangle(const dvec3& p, const std::array<dvec3, 3>& t) {
  const dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double area = glm::dot(n, n);
  double least =
      std::min({squaredToSegment(p, t[0], t[1]), squaredToSegment(p, t[1], t[2]), squaredToSegment(p, t[2], t[0])});
  if (!(area > 0.0)) return least;
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k)
    inside = inside && glm::dot(glm::cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0.0;
  const double height = glm::dot(p - t[0], n);
  return inside ? std::min(least, height * height / area) : least;
}

/// Triangles in the cells of an even grid that their boxes meet.
class TriangleGrid {
 public:
  explicit TriangleGrid(const TriangleMesh& mesh) : mesh_(mesh) {
    low_ = high_ = mesh.vertices.empty() ? dvec3(0.0) : mesh.vertices.front();
    for (const dvec3& vertex : mesh.vertices) {
      low_ = glm::min(low_, vertex);
      high_ = glm::max(high_, vertex);
    }
    const double cells = std::clamp(std::cbrt(static_cast<double>(mesh.triangles.size())), 1.0, 128.0);
    const dvec3 size = high_ - low_;
    cell_ = std::max({size.x, size.y, size.z, 1e-9}) / cells;
    for (int k = 0; k < 3; ++k) count_[k] = static_cast<int>(size[k] / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                  static_cast<std::size_t>(count_[2]));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) insert(i);
  }

  double nearest(const dvec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    const std::array<int, 3> at{place(p, 0), place(p, 1), place(p, 2)};
    const int most = std::max({count_[0], count_[1], count_[2]});
    for (int ring = 0; ring <= most; ++ring) {
      const double passed = (ring - 1) * cell_;  // What is farther out is at least so far away.
      if (passed > 0.0 && least <= passed * passed) break;
      lookAtRing(p, at, ring, least);
    }
    return std::sqrt(least);
  }

 private:
  int place(const dvec3& p, int k) const {
    return std::clamp(static_cast<int>(std::floor((p[k] - low_[k]) / cell_)), 0,
                      count_[static_cast<std::size_t>(k)] - 1);
  }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(x);
  }
  std::array<dvec3, 3> corners(std::size_t triangle) const {
    const auto& t = mesh_.triangles[triangle];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
  }

  void insert(std::size_t triangle) {
    const auto t = corners(triangle);
    const dvec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
    for (int z = place(low, 2); z <= place(high, 2); ++z)
      for (int y = place(low, 1); y <= place(high, 1); ++y)
        for (int x = place(low, 0); x <= place(high, 0); ++x) cells_[index(x, y, z)].push_back(triangle);
  }

  void lookAtRing(const dvec3& p, const std::array<int, 3>& at, int ring, double& least) const {
    const auto from = [&](std::size_t k) { return std::max(0, at[k] - ring); };
    const auto to = [&](std::size_t k) { return std::min(count_[k] - 1, at[k] + ring); };
    for (int z = from(2); z <= to(2); ++z) {
      for (int y = from(1); y <= to(1); ++y) {
        for (int x = from(0); x <= to(0); ++x) {
          if (std::max({std::abs(x - at[0]), std::abs(y - at[1]), std::abs(z - at[2])}) != ring) continue;
          for (const std::size_t i : cells_[index(x, y, z)]) least = std::min(least, squaredToTriangle(p, corners(i)));
        }
      }
    }
  }

  const TriangleMesh& mesh_;
  dvec3 low_{0.0}, high_{0.0};
  double cell_ = 1.0;
  std::array<int, 3> count_{1, 1, 1};
  std::vector<std::vector<std::size_t>> cells_;
};

void farthest(const TriangleMesh& from, const TriangleGrid& to, SurfaceDistance& most) {
  constexpr std::array<std::array<double, 3>, 7> kPlaces{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                                          {0.5, 0.5, 0.0},
                                                          {0.0, 0.5, 0.5},
                                                          {0.5, 0.0, 0.5},
                                                          {0.7, 0.15, 0.15},
                                                          {0.15, 0.7, 0.15},
                                                          {0.15, 0.15, 0.7}}};
  const auto look = [&](const dvec3& p) {
    const double distance = to.nearest(p);
    if (distance > most.distance) most = {distance, p};
  };
  // Triangles from which on their middles are enough: they are small then, and seven places each take seven times as
  // long. Half: bulges of coarse meshes may be missed; twice: twice the time.
  constexpr std::size_t kMany = 100'000;
  const std::size_t places = from.triangles.size() > kMany ? 1 : kPlaces.size();
  std::vector<bool> seen(from.vertices.size(), false);
  for (const auto& t : from.triangles) {
    for (const auto corner : t) {
      if (!seen[corner]) look(from.vertices[corner]);
      seen[corner] = true;
    }
    for (std::size_t k = 0; k < places; ++k) {
      const auto& w = kPlaces[k];
      look(w[0] * from.vertices[t[0]] + w[1] * from.vertices[t[1]] + w[2] * from.vertices[t[2]]);
    }
  }
}

}  // namespace

SurfaceDistance surfaceDistance(const TriangleMesh& a, const TriangleMesh& b) {
  if (a.triangles.empty() != b.triangles.empty()) return {std::numeric_limits<double>::infinity(), dvec3(0.0)};
  SurfaceDistance most;
  farthest(a, TriangleGrid(b), most);
  farthest(b, TriangleGrid(a), most);
  return most;
}

}  // namespace hapticell::geometry
