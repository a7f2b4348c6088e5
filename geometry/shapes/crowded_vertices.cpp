// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/crowded_vertices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>

#include "geometry/shapes/bounds.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::geometry {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;
// Parts by the first bits of the hash: one of ten million vertices' fits the second cache. Half, twice: no effect.
constexpr std::size_t kParts = 1024;
// Vertices for a thread to be worth it. Half, twice: no effect.
constexpr std::size_t kWorthAThread = 20'000;

/// A vertex in a cell that it stands in or that its tolerance reaches.
struct Visit {
  std::uint32_t hash = 0, vertex = 0;
};

std::int64_t roundedDown(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

std::uint64_t hashOf(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t hash = 0;
  for (const std::int64_t part : {x, y, z}) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;  // Each time: else cells that mirror each other about the origin have the same hash.
  }
  return hash * 0xBF58476D1CE4E5B9ull;
}

std::size_t partOf(std::uint64_t hash) {
  return hash >> 54;
}

/// Cells told apart by 42 bits of their hash: where two have the same, more vertices are compared.
class Visits {
 public:
  Visits(const std::vector<dvec3>& vertices, double tolerance) : vertices_(vertices) {
    const Bounds box = boundsOf(vertices);
    const dvec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    const double largest = std::max({farthest.x, farthest.y, farthest.z});
    // A little more than the tolerance, for what rounding loses. Half, twice: no effect.
    reach_ = tolerance * (1.0 + 1e-14) + 4e-16 * largest;
    // Cells of many tolerances: one vertex in ten reaches into a second. Half: one in five; twice: more stand in one.
    constexpr double kReaches = 64.0;
    per_cell_ = 1.0 / std::max({kReaches * reach_, 1e-12 * largest, 1e-300});
    sort();
  }

  std::vector<std::uint32_t> crowded() const {
    std::vector<std::uint8_t> marks;
    marks.resize(vertices_.size());
    inRanges(kParts, rangesOf(vertices_.size(), kWorthAThread), [&](std::size_t, std::size_t first, std::size_t last) {
      Chains chains;
      for (std::size_t part = first; part < last; ++part) {
        mark(std::span(visits_).subspan(begin_[part], begin_[part + 1] - begin_[part]), chains, marks);
      }
    });
    std::vector<std::uint32_t> result;
    for (std::uint32_t v = 0; v < marks.size(); ++v) {
      if (marks[v]) result.push_back(v);
    }
    return result;
  }

 private:
  using Counts = std::array<std::uint32_t, kParts>;

  /// The visits of one part by their hash, the latest first.
  struct Chains {
    std::vector<std::uint32_t> heads, next;
    std::vector<std::uint8_t> full;  ///< Of each visit: all before it in its cell are marked, and it is.
  };

  /// By the part, then by the vertex.
  void sort() {
    const std::size_t ranges = rangesOf(vertices_.size(), kWorthAThread);
    std::vector<Counts> places(ranges, Counts{});
    inRanges(vertices_.size(), ranges, [&](std::size_t range, std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) eachCell(v, [&](std::uint64_t hash) { ++places[range][partOf(hash)]; });
    });
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < kParts; ++part) {
      begin_[part] = sum;
      for (Counts& of_range : places) {
        const std::uint32_t count = of_range[part];
        of_range[part] = sum;
        sum += count;
      }
    }
    begin_[kParts] = sum;
    visits_.resize(sum);
    inRanges(vertices_.size(), ranges, [&](std::size_t range, std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        eachCell(v, [&](std::uint64_t hash) {
          visits_[places[range][partOf(hash)]++] = {static_cast<std::uint32_t>(hash >> 22), static_cast<std::uint32_t>(v)};
        });
      }
    });
  }

  template <typename See>
  void eachCell(std::size_t v, const See& see) const {
    std::array<std::int64_t, 3> low, high;
    for (int k = 0; k < 3; ++k) {
      low[static_cast<std::size_t>(k)] = roundedDown((vertices_[v][k] - reach_) * per_cell_);
      high[static_cast<std::size_t>(k)] = roundedDown((vertices_[v][k] + reach_) * per_cell_);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) see(hashOf(x, y, z));
      }
    }
  }

  /// Marks the vertices of one part that another one in the same cell is near.
  void mark(std::span<const Visit> visits, Chains& chains, std::vector<std::uint8_t>& marks) const {
    std::size_t size = 16;
    while (size < 2 * visits.size()) size *= 2;
    chains.heads.assign(size, kNone);
    chains.next.resize(visits.size());
    chains.full.assign(visits.size(), 0);
    const auto set = [&](std::uint32_t vertex) {
      std::atomic_ref<std::uint8_t>(marks[vertex]).store(1, std::memory_order_relaxed);
    };
    // Vertices compared in one cell; if there are more, all of them count as crowded. Half, twice: no effect.
    constexpr int kMost = 16;
    for (std::uint32_t k = 0; k < visits.size(); ++k) {
      const Visit& visit = visits[k];
      std::uint32_t& head = chains.heads[visit.hash & (size - 1)];
      int compared = 0;
      for (std::uint32_t j = head; j != kNone; j = chains.next[j]) {
        const Visit& other = visits[j];
        if (other.hash != visit.hash || other.vertex == visit.vertex) continue;
        const bool many = chains.full[j] != 0 || ++compared > kMost;
        if (many) chains.full[k] = 1;
        if (!many && glm::distance(vertices_[visit.vertex], vertices_[other.vertex]) > reach_) continue;
        set(visit.vertex);
        set(other.vertex);
        if (chains.full[j]) break;
      }
      if (chains.full[k] && compared > kMost) markAll(visits, chains, head, visit.hash, set);
      chains.next[k] = head;
      head = k;
    }
  }

  template <typename Set>
  static void markAll(std::span<const Visit> visits, const Chains& chains, std::uint32_t head, std::uint32_t hash,
                      const Set& set) {
    for (std::uint32_t j = head; j != kNone; j = chains.next[j]) {
      if (visits[j].hash == hash) set(visits[j].vertex);
    }
  }

  const std::vector<dvec3>& vertices_;
  double reach_ = 0.0, per_cell_ = 0.0;
  std::array<std::uint32_t, kParts + 1> begin_{};
  std::vector<Visit> visits_;
};

}  // namespace

std::vector<std::uint32_t> crowdedVertices(const std::vector<dvec3>& vertices, double tolerance) {
  return Visits(vertices, tolerance).crowded();
}

}  // namespace hapticell::geometry
