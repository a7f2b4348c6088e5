// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/shapes/vertex_merge.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::geometry {

namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

bool isDegenerate(const TriangleMesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  return glm::length(glm::cross(b - a, c - a)) == 0.0;
}

/// The triangle from its smallest corner on. The same corners in the same turning sense are a duplicate; turned round
/// they are the other side of a thin wall.
Triangle fromSmallest(Triangle t) {
  if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
  if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
  return t;
}

/// Marks those of `numbers` (triangles that have their smallest corner in common) that an earlier one equals.
void markRepeated(const TriangleMesh& mesh, std::span<std::uint32_t> numbers, std::vector<std::uint8_t>& repeated) {
  const auto key = [&](std::uint32_t number) { return fromSmallest(mesh.triangles[number]); };
  // Triangles from which on sorting is quicker than comparing each with each. Half, twice: no effect.
  constexpr std::size_t kFew = 12;
  if (numbers.size() <= kFew) {
    for (std::size_t k = 1; k < numbers.size(); ++k) {
      for (std::size_t j = 0; j < k && !repeated[numbers[k]]; ++j) repeated[numbers[k]] = key(numbers[j]) == key(numbers[k]);
    }
    return;
  }
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Triangle first = key(a), second = key(b);
    return first != second ? first < second : a < b;
  });
  for (std::size_t k = 1; k < numbers.size(); ++k) repeated[numbers[k]] = key(numbers[k - 1]) == key(numbers[k]);
}

/// Drops triangles that an earlier one equals, and says how many.
std::uint32_t dropDuplicates(TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size(), vertices = mesh.vertices.size();
  std::vector<std::uint32_t> begin, numbers;
  begin.resize(vertices + 1);
  numbers.resize(count);
  const auto smallest = [&](std::size_t number) {
    const Triangle& t = mesh.triangles[number];
    return std::min({t[0], t[1], t[2]});
  };
  for (std::size_t k = 0; k < count; ++k) ++begin[smallest(k)];
  std::uint32_t sum = 0;  // Each place becomes the end of its triangles, from where they are filled in backwards.
  for (std::uint32_t& place : begin) place = sum += place;
  for (std::size_t k = count; k-- > 0;) numbers[--begin[smallest(k)]] = static_cast<std::uint32_t>(k);
  std::vector<std::uint8_t> repeated(count, 0);
  // Vertices for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 20'000;
  inRanges(vertices, rangesOf(vertices, kLeast), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      markRepeated(mesh, std::span(numbers).subspan(begin[v], begin[v + 1] - begin[v]), repeated);
    }
  });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!repeated[k]) mesh.triangles[kept++] = mesh.triangles[k];
  }
  mesh.triangles.resize(kept);
  return static_cast<std::uint32_t>(count - kept);
}

/// Each vertex is used, and its first use is behind those of all before it.
bool isInOrderOfUse(const TriangleMesh& mesh) {
  std::uint32_t next = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t index : t) {
      if (index > next) return false;
      next += index == next ? 1u : 0u;
    }
  }
  return next == mesh.vertices.size();
}

void dropUnusedVertices(TriangleMesh& mesh) {
  if (isInOrderOfUse(mesh)) return;
  std::vector<std::uint32_t> renamed;
  renamed.resize(mesh.vertices.size(), kUnused);
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

/// Gives each triangle the corners that its own are the same as, drops those without area and says how many.
std::uint32_t renameCorners(TriangleMesh& mesh, const std::vector<std::uint32_t>& same_as) {
  // Triangles for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 50'000;
  const std::size_t count = mesh.triangles.size();
  struct Kept {
    std::size_t first = 0, count = 0;
  };
  std::vector<Kept> of_ranges(rangesOf(count, kLeast));
  inRanges(count, of_ranges.size(), [&](std::size_t range, std::size_t first, std::size_t last) {
    std::size_t place = first;
    for (std::size_t k = first; k < last; ++k) {
      Triangle t = mesh.triangles[k];
      for (std::uint32_t& index : t) index = same_as[index];
      if (!isDegenerate(mesh, t)) mesh.triangles[place++] = t;
    }
    of_ranges[range] = {first, place - first};
  });
  std::size_t kept = 0;
  for (const Kept& range : of_ranges) {
    const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(range.first);
    if (kept != range.first) {
      std::copy(begin, begin + static_cast<std::ptrdiff_t>(range.count),
                mesh.triangles.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    kept += range.count;
  }
  mesh.triangles.resize(kept);
  return static_cast<std::uint32_t>(count - kept);
}

}  // namespace

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
  {
    const std::vector<std::uint32_t> same_as = mergedVertices(mesh.vertices, tolerance, &report.merged_vertices);
    report.degenerate_triangles = renameCorners(mesh, same_as);
  }
  report.duplicate_triangles = dropDuplicates(mesh);
  dropUnusedVertices(mesh);
  return report;
}

void append(TriangleMesh& whole, const TriangleMesh& part_B, const Pose& X_AB) {
  const auto offset = static_cast<std::uint32_t>(whole.vertices.size());
  for (const dvec3& p_BV : part_B.vertices) whole.vertices.push_back(X_AB * p_BV);
  for (const Triangle& t : part_B.triangles) whole.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

}  // namespace hapticell::geometry
