// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/topology.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/shapes/edge_uses.h"
#include "geometry/shapes/half_edge_counts.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::geometry {

namespace {

constexpr std::uint32_t kBorder = 0xFFFFFFFFu;     // No other triangle.
constexpr std::uint32_t kIrregular = 0xFFFFFFFEu;  // Several others, or one that faces the other way.
// Vertices for a thread to be worth it. Half, twice: no effect.
constexpr std::size_t kLeastVertices = 20'000;

bool isDegenerate(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::uint32_t before(std::uint32_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// Trees of numbers that belong together; the root is the least of them.
class Groups {
 public:
  explicit Groups(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), 0u); }
  std::uint32_t find(std::uint32_t k) {
    while (root_[k] != k) k = root_[k] = root_[root_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    root_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> root_;
};

/// Corners are those of EdgeUses. No triangle has a corner twice.
class Surface {
 public:
  Surface(const TriangleMesh& mesh, std::span<const Triangle> triangles)
      : mesh_(mesh), triangles_(triangles), odd_(mesh.vertices.size(), 0) {
    opposite_.resize(3 * triangles.size(), kBorder);
    pairCorners();
    findFans();
  }

  Topology counts() {
    Topology counts;
    const std::vector<bool> plain = plainTriangles();
    if (!all_plain_) {
      std::vector<Triangle> others;
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (!plain[t]) others.push_back(triangles_[t]);
      }
      counts = halfEdgeCounts(mesh_, others);
    }
    counts.closed = closed_ && !triangles_.empty();
    // Each writes counts of its own.
    inRanges(2, rangesOf(triangles_.size(), kLeastVertices) > 1 ? 2 : 1,
             [&](std::size_t, std::size_t first, std::size_t last) {
               for (std::size_t work = first; work < last; ++work) {
                 if (work == 0) {
                   countShells(plain, counts);
                 } else {
                   countEdges(plain, counts);
                   countBorders(plain, counts);
                 }
               }
             });
    return counts;
  }

 private:
  std::uint32_t vertexAt(std::uint32_t corner) const { return triangles_[corner / 3][corner % 3]; }

  void pairCorners() {
    const EdgeUses edges(triangles_, mesh_.vertices.size());
    const std::size_t ranges = rangesOf(edges.vertices(), kLeastVertices);
    std::vector<std::uint8_t> open(ranges, 0), mixed(ranges, 0);
    inRanges(edges.vertices(), ranges, [&](std::size_t range, std::size_t first, std::size_t last) {
      edges.each(first, last, [&](std::span<const EdgeUses::Use> uses) {
        std::ptrdiff_t balance = 0;
        for (const EdgeUses::Use& use : uses) balance += use.up() ? 1 : -1;
        if (balance != 0) open[range] = 1;
        if (uses.size() == 2 && balance == 0) {
          opposite_[uses[0].corner()] = uses[1].corner();
          opposite_[uses[1].corner()] = uses[0].corner();
          return;
        }
        mixed[range] = 1;
        if (uses.size() == 1) return;
        for (const EdgeUses::Use& use : uses) opposite_[use.corner()] = kIrregular;
      });
    });
    closed_ = std::count(open.begin(), open.end(), 0) == static_cast<std::ptrdiff_t>(ranges);
    all_paired_ = std::count(mixed.begin(), mixed.end(), 0) == static_cast<std::ptrdiff_t>(ranges);
  }

  /// Marks vertices that more than one ring or fan of triangles surrounds, and those of irregular edges.
  void findFans() {
    start_.resize(odd_.size(), kBorder);
    std::vector<std::uint32_t> valence;
    valence.resize(odd_.size());
    for (std::uint32_t corner = 0; corner < opposite_.size(); ++corner) {
      const std::uint32_t v = vertexAt(corner);
      ++valence[v];
      if (opposite_[corner] == kIrregular) {
        const Triangle& t = triangles_[corner / 3];
        odd_[v] = odd_[t[(corner + 1) % 3]] = 1;
      }
      const bool begins = opposite_[corner] == kBorder;
      if (begins && start_[v] != kBorder && opposite_[start_[v]] == kBorder) odd_[v] = 1;
      if (begins || start_[v] == kBorder) start_[v] = corner;
    }
    inRanges(odd_.size(), rangesOf(odd_.size(), kLeastVertices), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        if (valence[v] > 0 && !odd_[v] && around(start_[v], valence[v]) != valence[v]) odd_[v] = 1;
      }
    });
  }

  /// Triangles from one corner on around its vertex; at most `most`.
  std::uint32_t around(std::uint32_t start, std::uint32_t most) const {
    std::uint32_t count = 1, corner = opposite_[before(start)];
    for (; corner < kIrregular && corner != start && count < most; ++count) corner = opposite_[before(corner)];
    return count;
  }

  /// All triangles but those of parts with an odd vertex.
  std::vector<bool> plainTriangles() {
    std::vector<bool> plain(triangles_.size(), true);
    all_plain_ = std::find(odd_.begin(), odd_.end(), 1) == odd_.end();
    if (all_plain_) return plain;
    Groups parts(odd_.size());
    for (const Triangle& t : triangles_) {
      parts.join(t[0], t[1]);
      parts.join(t[0], t[2]);
    }
    std::vector<bool> odd_part(odd_.size(), false);
    for (std::uint32_t v = 0; v < odd_.size(); ++v) {
      if (odd_[v]) odd_part[parts.find(v)] = true;
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) plain[t] = !odd_part[parts.find(triangles_[t][0])];
    return plain;
  }

  void countEdges(const std::vector<bool>& plain, Topology& counts) const {
    std::int64_t faces = 0, sides = 0, vertices = 0;  // An edge has two sides.
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!plain[t]) continue;
      ++faces;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto corner = static_cast<std::uint32_t>(3 * t + k);
        sides += opposite_[corner] == kBorder ? 2 : 1;
        vertices += start_[triangles_[t][k]] == corner ? 1 : 0;
      }
    }
    counts.euler_characteristic += static_cast<int>(vertices - sides / 2 + faces);
  }

  /// A border goes on where the fan at its end begins.
  void countBorders(const std::vector<bool>& plain, Topology& counts) const {
    std::vector<bool> seen(odd_.size(), false);
    for (std::uint32_t corner = 0; corner < opposite_.size(); ++corner) {
      if (opposite_[corner] != kBorder || !plain[corner / 3] || seen[vertexAt(corner)]) continue;
      ++counts.holes;
      for (std::uint32_t at = corner; !seen[vertexAt(at)];) {
        seen[vertexAt(at)] = true;
        ++counts.border_edges;
        at = start_[triangles_[at / 3][(at + 1) % 3]];
      }
    }
  }

  void countShells(const std::vector<bool>& plain, Topology& counts) const {
    Groups groups(triangles_.size());
    for (std::uint32_t corner = 0; corner < opposite_.size(); ++corner) {
      if (opposite_[corner] < kIrregular && opposite_[corner] > corner) groups.join(corner / 3, opposite_[corner] / 3);
    }
    struct Swept {
      double volume = 0.0, all = 0.0;  // m3, six times.
    };
    std::unordered_map<std::uint32_t, Swept> shells;
    std::uint32_t last = kBorder;
    Swept* swept = nullptr;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t root = groups.find(t);
      if (root == t && plain[t]) ++counts.shells;
      if (!all_paired_) continue;
      if (root != last) swept = &shells[last = root];
      const dvec3 origin = mesh_.vertices[triangles_[root][0]];
      const auto corner = [&](std::size_t k) { return mesh_.vertices[triangles_[t][k]] - origin; };
      const double volume = glm::dot(corner(0), glm::cross(corner(1), corner(2)));
      swept->volume += volume;
      swept->all += std::abs(volume);
    }
    if (shells.empty()) return;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [root, of_shell] : shells) {
      least = std::min(least, of_shell.all > 0.0 ? of_shell.volume / of_shell.all : 0.0);
    }
    counts.least_volume_share = least;
  }

  const TriangleMesh& mesh_;
  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> opposite_;  // Of each corner, the corner of the edge's other triangle.
  std::vector<std::uint8_t> odd_;        // Of each vertex.
  std::vector<std::uint32_t> start_;     // Of each vertex, the first corner of its fan.
  bool closed_ = true, all_paired_ = true, all_plain_ = true;
};

}  // namespace

Topology topologyOf(const TriangleMesh& mesh) {
  if (std::none_of(mesh.triangles.begin(), mesh.triangles.end(), isDegenerate))
    return Surface(mesh, mesh.triangles).counts();
  std::vector<Triangle> sound;
  std::copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(sound),
               [](const Triangle& t) { return !isDegenerate(t); });
  Topology counts = Surface(mesh, sound).counts();
  counts.rejected_triangles += static_cast<std::uint32_t>(mesh.triangles.size() - sound.size());
  counts.closed = counts.closed || (sound.empty() && !mesh.triangles.empty());
  counts.least_volume_share = 0.0;
  return counts;
}

}  // namespace hapticell::geometry
