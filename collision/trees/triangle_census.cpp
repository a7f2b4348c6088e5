// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/triangle_census.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

namespace {

constexpr std::uint32_t kNoTriangle = 0xFFFFFFFFu;

using Words = std::array<std::uint64_t, 3>;

std::uint64_t hashOf(const Words& words) {
  std::uint64_t hash = 0x9E3779B97F4A7C15ull;
  for (const std::uint64_t word : words) {
    hash = (hash ^ word) * 0xC2B2AE3D27D4EB4Full;
    hash ^= hash >> 29;
  }
  return hash;
}

/// The first of equal triples of words, found again: open addressing.
class FirstOfEqual {
 public:
  explicit FirstOfEqual(std::size_t count) : slots_(std::bit_ceil(2 * count + 1), kNoTriangle) {}

  /// The item equal to this one that was given first; `equals(i)` compares with an earlier item.
  template <typename Equals>
  std::uint32_t find(std::uint32_t item, std::uint64_t hash, const Equals& equals) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
      if (slots_[at] == kNoTriangle) {
        slots_[at] = item;
        return item;
      }
      if (equals(slots_[at])) return slots_[at];
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
};

/// Equal for what is the same bit for bit: -0 is not 0.
Words bitsOf(const dvec3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y), std::bit_cast<std::uint64_t>(p.z)};
}

bool isDegenerate(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 normal = glm::cross(b - a, c - a);
  return !(glm::dot(normal, normal) > 0.0);
}

}  // namespace

CountedTriangles countTriangles(const geometry::TriangleMesh& mesh) {
  CountedTriangles counted;
  counted.kept.reserve(mesh.triangles.size());
  FirstOfEqual first(mesh.triangles.size());
  const auto sorted = [&](std::uint32_t t) {
    geometry::Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    if (!isFinite(a) || !isFinite(b) || !isFinite(c)) {
      ++counted.census.non_finite;
      continue;
    }
    const geometry::Triangle corners = sorted(t);
    const Words words = {corners[0], corners[1], corners[2]};
    if (first.find(t, hashOf(words), [&](std::uint32_t other) { return sorted(other) == corners; }) != t) {
      ++counted.census.duplicate;
      continue;
    }
    if (isDegenerate(a, b, c)) ++counted.census.degenerate;
    counted.kept.push_back(t);
  }
  return counted;
}

geometry::TriangleMesh shareVertices(const geometry::TriangleMesh& mesh) {
  if (2 * mesh.vertices.size() <= 3 * mesh.triangles.size()) return mesh;
  FirstOfEqual first(mesh.vertices.size());
  std::vector<std::uint32_t> new_index(mesh.vertices.size());
  geometry::TriangleMesh shared;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Words words = bitsOf(mesh.vertices[v]);
    const std::uint32_t same =
        first.find(v, hashOf(words), [&](std::uint32_t other) { return bitsOf(mesh.vertices[other]) == words; });
    if (same == v) {
      new_index[v] = static_cast<std::uint32_t>(shared.vertices.size());
      shared.vertices.push_back(mesh.vertices[v]);
    } else {
      new_index[v] = new_index[same];
    }
  }
  shared.vertices.shrink_to_fit();
  shared.triangles.reserve(mesh.triangles.size());
  for (const geometry::Triangle& t : mesh.triangles) {
    shared.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
  }
  return shared;
}

}  // namespace hapticell::collision
