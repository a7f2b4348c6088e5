// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/contact_regions.h"

#include <array>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "collision/queries/mesh_search.h"

namespace hapticell::collision {

namespace {

/// Numbers corners by where they are, since a soup's triangles share places but not vertices.
class CornerNumbers {
 public:
  explicit CornerNumbers(const geometry::TriangleMesh& mesh) : mesh_(mesh) {}

  std::uint64_t operator()(std::uint32_t triangle, int corner) {
    const dvec3 p = mesh_.corner(triangle, corner);
    return numbers_.try_emplace(std::tuple(p.x, p.y, p.z), numbers_.size()).first->second;
  }

 private:
  const geometry::TriangleMesh& mesh_;
  std::map<std::tuple<double, double, double>, std::uint64_t> numbers_;
};

std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::size_t countContactRegions(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double zone,
                                std::size_t most_pairs) {
  std::vector<TrianglePair> pairs;
  trianglePairsWithin(a, b, X_AB, zone, pairs, most_pairs);
  std::vector<std::size_t> parent(pairs.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  CornerNumbers corners_a(a.mesh()), corners_b(b.mesh());
  std::unordered_map<std::uint64_t, std::size_t> pair_of_corners;
  std::size_t regions = pairs.size();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (int k = 0; k < 9; ++k) {
      const std::uint64_t key = (corners_a(pairs[i].triangle_a, k / 3) << 32) | corners_b(pairs[i].triangle_b, k % 3);
      const std::size_t other = rootOf(parent, pair_of_corners.try_emplace(key, i).first->second);
      const std::size_t own = rootOf(parent, i);
      if (other == own) continue;
      parent[own] = other;
      --regions;
    }
  }
  return regions;
}

}  // namespace hapticell::collision
