// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace hapticell::geometry {

namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  a ^= b + 0x9E3779B97F4A7C15ull + (a << 6) + (a >> 2);
  return a * 0xBF58476D1CE4E5B9ull;
}

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    return mix(mix(static_cast<std::uint64_t>(c.x), static_cast<std::uint64_t>(c.y)), static_cast<std::uint64_t>(c.z));
  }
};

struct TriangleHash {
  std::size_t operator()(const Triangle& t) const { return mix(mix(t[0], t[1]), t[2]); }
};

Cell cellOf(const dvec3& point, double size) {
  const dvec3 scaled = glm::floor(point / size);
  return {static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
          static_cast<std::int64_t>(scaled.z)};
}

/// For each vertex the index of the first vertex within tolerance of it, found in a grid of cells of that size.
std::vector<std::uint32_t> representatives(const std::vector<dvec3>& vertices, double tolerance,
                                           std::uint32_t& merged) {
  const double size = std::max(tolerance, 1e-300);
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> grid;
  grid.reserve(vertices.size());
  std::vector<std::uint32_t> result(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Cell home = cellOf(vertices[i], size);
    std::uint32_t found = kUnused;
    for (int k = 0; k < 27 && found == kUnused; ++k) {
      const auto it = grid.find({home.x + k % 3 - 1, home.y + (k / 3) % 3 - 1, home.z + k / 9 - 1});
      if (it == grid.end()) continue;
      for (std::uint32_t j : it->second) {
        if (glm::distance(vertices[i], vertices[j]) <= tolerance) found = j;
      }
    }
    if (found == kUnused) {
      grid[home].push_back(i);
      found = i;
    } else {
      ++merged;
    }
    result[i] = found;
  }
  return result;
}

bool isDegenerate(const TriangleMesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  return glm::length(glm::cross(b - a, c - a)) == 0.0;
}

void dropUnusedVertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> renamed(mesh.vertices.size(), kUnused);
  std::vector<dvec3> kept;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& index : t) {
      if (renamed[index] == kUnused) {
        renamed[index] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.vertices[index]);
      }
      index = renamed[index];
    }
  }
  mesh.vertices = std::move(kept);
}

}  // namespace

Bounds TriangleMesh::bounds() const {
  return boundsOf(vertices);
}

double weldTolerance(const TriangleMesh& mesh) {
  const Bounds box = mesh.bounds();
  if (box.isEmpty()) return 0.0;
  const dvec3 largest = glm::max(glm::abs(box.min), glm::abs(box.max));
  return 1e-6 * std::max({largest.x, largest.y, largest.z});
}

WeldReport weld(TriangleMesh& mesh, double tolerance) {
  WeldReport report;
  const std::vector<std::uint32_t> same_as = representatives(mesh.vertices, tolerance, report.merged_vertices);
  std::unordered_set<Triangle, TriangleHash> seen;
  seen.reserve(mesh.triangles.size());
  std::vector<Triangle> kept;
  kept.reserve(mesh.triangles.size());
  for (Triangle t : mesh.triangles) {
    for (std::uint32_t& index : t) index = same_as[index];
    if (isDegenerate(mesh, t)) {
      ++report.degenerate_triangles;
      continue;
    }
    // The same corners in the same turning sense are a duplicate; turned round they are the other side of a thin wall.
    Triangle key = t;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    if (!seen.insert(key).second) {
      ++report.duplicate_triangles;
      continue;
    }
    kept.push_back(t);
  }
  mesh.triangles = std::move(kept);
  dropUnusedVertices(mesh);
  return report;
}

void append(TriangleMesh& whole, const TriangleMesh& part_B, const Pose& X_AB) {
  const auto offset = static_cast<std::uint32_t>(whole.vertices.size());
  for (const dvec3& p_BV : part_B.vertices) whole.vertices.push_back(X_AB * p_BV);
  for (const Triangle& t : part_B.triangles) whole.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

}  // namespace hapticell::geometry
