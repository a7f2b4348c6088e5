// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "geometry/shapes/vertex_merge.h"

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

/// Kept vertices by the cell they stand in; those of one cell form a chain.
class VertexGrid {
 public:
  VertexGrid(const std::vector<dvec3>& vertices, double tolerance, double size)
      : vertices_(vertices), tolerance_(tolerance), size_(size), next_(vertices.size(), kUnused) {
    first_.reserve(vertices.size() / 2);
  }

  /// The first kept vertex within tolerance of vertex i, looked for in the cells that the tolerance reaches (mostly
  /// one).
  std::uint32_t find(std::uint32_t i) const {
    const Cell low = cellOf(vertices_[i] - tolerance_, size_), high = cellOf(vertices_[i] + tolerance_, size_);
    std::uint32_t found = kUnused;
    for (std::int64_t x = low.x; x <= high.x; ++x) {
      for (std::int64_t y = low.y; y <= high.y; ++y) {
        for (std::int64_t z = low.z; z <= high.z; ++z) found = std::min(found, findIn({x, y, z}, i));
      }
    }
    return found;
  }

  void keep(std::uint32_t i) {
    const auto [it, is_new] = first_.try_emplace(cellOf(vertices_[i], size_), i);
    if (is_new) return;
    next_[i] = it->second;
    it->second = i;
  }

 private:
  std::uint32_t findIn(const Cell& cell, std::uint32_t i) const {
    const auto it = first_.find(cell);
    std::uint32_t found = kUnused;
    for (std::uint32_t j = it == first_.end() ? kUnused : it->second; j != kUnused; j = next_[j]) {
      if (glm::distance(vertices_[i], vertices_[j]) <= tolerance_) found = std::min(found, j);
    }
    return found;
  }

  const std::vector<dvec3>& vertices_;
  double tolerance_;
  double size_;
  std::unordered_map<Cell, std::uint32_t, CellHash> first_;
  std::vector<std::uint32_t> next_;
};

/// For each vertex the index of the first kept vertex within tolerance of it; itself if there is no such vertex.
std::vector<std::uint32_t> representatives(const std::vector<dvec3>& vertices, double tolerance,
                                           std::uint32_t& merged) {
  const Bounds box = boundsOf(vertices);
  const dvec3 largest = box.isEmpty() ? dvec3(0.0) : glm::max(glm::abs(box.min), glm::abs(box.max));
  // Cells of a few tolerances; not so small that their number would not fit an integer.
  const double size = std::max({4.0 * tolerance, 1e-12 * std::max({largest.x, largest.y, largest.z}), 1e-300});
  VertexGrid grid(vertices, tolerance, size);
  std::vector<std::uint32_t> result(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t found = grid.find(i);
    if (found == kUnused) {
      grid.keep(i);
    } else {
      ++merged;
    }
    result[i] = found == kUnused ? i : found;
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

std::vector<std::uint32_t> mergedVertices(const std::vector<dvec3>& vertices, double tolerance) {
  std::uint32_t ignored = 0;
  return representatives(vertices, tolerance, ignored);
}

Bounds TriangleMesh::bounds() const {
  return boundsOf(vertices);
}

double weldTolerance(const TriangleMesh& mesh) {
  const Bounds box = mesh.bounds();
  if (box.isEmpty()) return 0.0;
  // A mesh that is small beside its distance from the origin is welded as finely as it would be there.
  const dvec3 largest = glm::max(glm::abs(box.min), glm::abs(box.max)), size = box.size();
  return 1e-6 * std::min(std::max({largest.x, largest.y, largest.z}), std::max({size.x, size.y, size.z}));
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
