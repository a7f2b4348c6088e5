// SPDX-License-Identifier: Apache-2.0
#include "geometry/normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/mesh_edges.h"

namespace hapticell::geometry {

namespace {

/// Corners (3 * triangle + k) that share one normal, as sets that grow together (R. E. Tarjan's union by path halving).
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t corner) {
    while (parent_[corner] != corner) {
      parent_[corner] = parent_[parent_[corner]];
      corner = parent_[corner];
    }
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

std::uint32_t cornerAt(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
  const Triangle& t = mesh.triangles[triangle];
  const std::uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  return 3 * triangle + k;
}

CornerSets smoothSets(const TriangleMesh& mesh, const std::vector<dvec3>& normals, double crease_angle) {
  CornerSets sets(3 * mesh.triangles.size());
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
  const double flattest = std::cos(crease_angle);
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    end = endOfEdge(uses, begin);
    if (!isConnected(uses, begin, end)) continue;
    const std::uint32_t s = uses[begin].triangle, t = uses[begin + 1].triangle;
    const bool both_have_area = glm::dot(normals[s], normals[s]) > 0.0 && glm::dot(normals[t], normals[t]) > 0.0;
    if (both_have_area && glm::dot(normals[s], normals[t]) < flattest) continue;
    for (std::uint32_t vertex : {uses[begin].low, uses[begin].high}) {
      sets.join(cornerAt(mesh, s, vertex), cornerAt(mesh, t, vertex));
    }
  }
  return sets;
}

double angleAt(const TriangleMesh& mesh, std::uint32_t triangle, int corner) {
  const dvec3 at = mesh.corner(triangle, corner);
  const dvec3 u = mesh.corner(triangle, (corner + 1) % 3) - at, v = mesh.corner(triangle, (corner + 2) % 3) - at;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// The normal of each set stands at its root corner.
std::vector<dvec3> rootNormals(const TriangleMesh& mesh, const std::vector<dvec3>& normals, CornerSets& sets) {
  std::vector<dvec3> sums(3 * mesh.triangles.size(), dvec3(0.0));
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t root = sets.find(3 * triangle + static_cast<std::uint32_t>(k));
      sums[root] += angleAt(mesh, triangle, k) * normals[triangle];
    }
  }
  for (dvec3& sum : sums) {
    const double length = glm::length(sum);
    sum = length > 1e-12 ? sum / length : dvec3(0.0, 0.0, 1.0);
  }
  return sums;
}

}  // namespace

std::vector<dvec3> cornerNormals(const TriangleMesh& mesh, double crease_angle) {
  const std::vector<dvec3> normals = triangleNormals(mesh);
  CornerSets sets = smoothSets(mesh, normals, crease_angle);
  const std::vector<dvec3> roots = rootNormals(mesh, normals, sets);
  std::vector<dvec3> corners(roots.size());
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) corners[corner] = roots[sets.find(corner)];
  return corners;
}

ShadedMesh shadedMesh(const TriangleMesh& mesh, double crease_angle) {
  ShadedMesh shaded;
  if (mesh.triangles.empty()) return shaded;
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  shaded.origin = mesh.bounds().center();
  const std::vector<dvec3> normals = triangleNormals(mesh);
  CornerSets sets = smoothSets(mesh, normals, crease_angle);
  const std::vector<dvec3> roots = rootNormals(mesh, normals, sets);
  std::vector<std::uint32_t> place(roots.size(), kNone);
  shaded.indices.reserve(roots.size());
  for (std::uint32_t corner = 0; corner < roots.size(); ++corner) {
    const std::uint32_t root = sets.find(corner);
    if (place[root] == kNone) {
      place[root] = static_cast<std::uint32_t>(shaded.positions.size());
      shaded.positions.emplace_back(mesh.corner(corner / 3, static_cast<int>(corner % 3)) - shaded.origin);
      shaded.normals.emplace_back(roots[root]);
    }
    shaded.indices.push_back(place[root]);
  }
  return shaded;
}

}  // namespace hapticell::geometry
