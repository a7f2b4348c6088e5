// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/surface_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "collision/pieces/patch_merger.h"

namespace hapticell::collision {
namespace {

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Gives equal positions (within the weld tolerance) one vertex, by rounding to a grid and its neighbours.
std::vector<std::uint32_t> weldedIndices(const geometry::TriangleMesh& mesh, double tolerance) {
  using Cell = std::array<std::int64_t, 3>;
  std::map<Cell, std::vector<std::uint32_t>> grid;
  std::vector<std::uint32_t> index(mesh.vertices.size());
  const auto cellOf = [&](const dvec3& p) {
    return Cell{std::llround(p.x / tolerance / 4.0), std::llround(p.y / tolerance / 4.0),
                std::llround(p.z / tolerance / 4.0)};
  };
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    const Cell low = cellOf(mesh.vertices[i] - dvec3(tolerance));
    const Cell high = cellOf(mesh.vertices[i] + dvec3(tolerance));
    index[i] = i;
    for (auto x = low[0]; x <= high[0]; ++x) {
      for (auto y = low[1]; y <= high[1]; ++y) {
        for (auto z = low[2]; z <= high[2]; ++z) {
          const auto found = grid.find({x, y, z});
          if (found == grid.end()) continue;
          for (const auto other : found->second) {
            if (glm::length(mesh.vertices[other] - mesh.vertices[i]) <= tolerance) index[i] = std::min(index[i], other);
          }
        }
      }
    }
    if (index[i] == i) grid[cellOf(mesh.vertices[i])].push_back(i);
  }
  return index;
}

}  // namespace

SurfaceGraph::SurfaceGraph(const geometry::TriangleMesh& mesh, double tolerance) : tolerance_(tolerance) {
  size_ = glm::length(mesh.bounds().size());
  dropDegenerate(mesh);
  connect();
}

void SurfaceGraph::dropDegenerate(const geometry::TriangleMesh& mesh) {
  const auto index = weldedIndices(mesh, std::max(1e-12, geometry::weldTolerance(mesh)));
  mesh_.vertices = mesh.vertices;
  std::map<geometry::Triangle, bool> seen;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    geometry::Triangle t = mesh.triangles[i];
    for (auto& corner : t) corner = index[corner];
    const dvec3 normal =
        glm::cross(mesh_.vertices[t[1]] - mesh_.vertices[t[0]], mesh_.vertices[t[2]] - mesh_.vertices[t[0]]);
    const double length = glm::length(normal);
    if (length <= 1e-14 * size_ * size_) continue;
    geometry::Triangle key = t;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    if (!seen.emplace(key, true).second) continue;
    mesh_.triangles.push_back(t);
    normals_.push_back(normal / length);
    areas_.push_back(0.5 * length);
    original_.push_back(i);
  }
}

void SurfaceGraph::connect() {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> users;  // edge -> 3 * triangle + k
  for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto a = mesh_.triangles[i][k];
      const auto b = mesh_.triangles[i][(k + 1) % 3];
      users[std::minmax(a, b)].push_back(3 * i + k);
    }
  }
  neighbours_.assign(mesh_.triangles.size(), {kNone, kNone, kNone});
  for (const auto& [edge, who] : users) {
    if (who.size() != 2) continue;
    const auto from = [&](std::uint32_t user) { return mesh_.triangles[user / 3][user % 3]; };
    if (from(who[0]) == from(who[1])) continue;
    neighbours_[who[0] / 3][who[0] % 3] = who[1] / 3;
    neighbours_[who[1] / 3][who[1] % 3] = who[0] / 3;
  }
}

bool SurfaceGraph::isConvexAcross(std::uint32_t triangle, int k) const {
  const auto other = neighbour(triangle, k);
  if (other == kNone) return false;
  const dvec3 origin = mesh_.corner(triangle, k);
  for (int i = 0; i < 3; ++i) {
    if (glm::dot(normals_[triangle], mesh_.corner(other, i) - origin) > tolerance_) return false;
  }
  return true;
}

bool SurfaceGraph::isFlat(const Patch& patch) const {
  const auto first = patch.triangles.front();
  const dvec3 origin = mesh_.corner(first, 0);
  return std::all_of(patch.vertices.begin(), patch.vertices.end(), [&](auto vertex) {
    return std::abs(glm::dot(normals_[first], mesh_.vertices[vertex] - origin)) <= tolerance_;
  });
}

std::vector<dvec3> SurfaceGraph::normalsBeyond(const Patch& patch) const {
  std::vector<std::uint32_t> own = patch.triangles;
  std::sort(own.begin(), own.end());
  std::vector<dvec3> normals;
  for (const auto triangle : own) {
    for (int k = 0; k < 3; ++k) {
      const auto other = neighbour(triangle, k);
      if (other == kNone || std::binary_search(own.begin(), own.end(), other)) continue;
      if (!isConvexAcross(triangle, k)) continue;
      const dvec3& n = normals_[other];
      const bool known =
          std::any_of(normals.begin(), normals.end(), [&](const dvec3& m) { return glm::dot(m, n) > 1 - 1e-8; });
      if (!known && glm::dot(n, normals_[triangle]) < 1.0 - 1e-8) normals.push_back(n);
    }
  }
  return normals;
}

Patch SurfaceGraph::patchOf(std::vector<std::uint32_t> triangles) const {
  Patch patch{std::move(triangles), {}};
  for (const auto triangle : patch.triangles) {
    patch.vertices.insert(patch.vertices.end(), mesh_.triangles[triangle].begin(), mesh_.triangles[triangle].end());
  }
  std::sort(patch.vertices.begin(), patch.vertices.end());
  patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()), patch.vertices.end());
  return patch;
}

std::vector<std::vector<std::uint32_t>> SurfaceGraph::components() const {
  std::vector<std::uint32_t> parent(mesh_.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const auto& t : mesh_.triangles) {
    parent[rootOf(parent, t[1])] = rootOf(parent, t[0]);
    parent[rootOf(parent, t[2])] = rootOf(parent, t[0]);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_root;
  for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
    by_root[rootOf(parent, mesh_.triangles[i][0])].push_back(i);
  std::vector<std::vector<std::uint32_t>> result;
  result.reserve(by_root.size());
  for (auto& [root, triangles] : by_root) result.push_back(std::move(triangles));
  return result;
}

std::vector<Patch> convexPatches(const SurfaceGraph& graph, const MeshCollider& collider) {
  std::vector<Patch> patches, hollow;
  for (auto& component : graph.components()) {
    Patch whole = graph.patchOf(std::move(component));
    (isConvexSurface(graph, whole) ? patches : hollow).push_back(std::move(whole));
  }
  for (Patch& patch : mergedPatches(graph, hollow, collider)) patches.push_back(std::move(patch));
  return patches;
}

}  // namespace hapticell::collision
