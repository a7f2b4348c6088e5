// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/vertex_merge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/shapes/bounds.h"
#include "geometry/shapes/crowded_vertices.h"

namespace hapticell::geometry {

namespace {

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

using Cell = std::array<std::int64_t, 3>;

std::uint32_t hashOf(const Cell& cell) {
  std::uint64_t hash = 0;
  for (const std::int64_t part : cell) hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ull;
  return static_cast<std::uint32_t>((hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9ull >> 32);
}

std::int64_t cellBelow(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

/// Kept vertices by the cell they stand in, in one open-addressed table; those of one cell form a chain. Cells are told
/// apart by 32 bits of their hash only: where two have the same, their chain is longer and no answer is another one.
class VertexGrid {
 public:
  VertexGrid(const std::vector<dvec3>& vertices, double tolerance, double size)
      : vertices_(vertices), tolerance_(tolerance), per_cell_(1.0 / size), next_(vertices.size(), kNoVertex) {
    resize(std::size_t{1} << 10);
  }

  /// The first kept vertex within tolerance of vertex i, looked for in the cells that the tolerance reaches.
  std::uint32_t find(std::uint32_t i) const {
    const Cell low = cellOf(vertices_[i] - tolerance_), high = cellOf(vertices_[i] + tolerance_);
    std::uint32_t found = kNoVertex;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) found = std::min(found, findIn(hashOf({x, y, z}), i));
      }
    }
    return found;
  }

  void keep(std::uint32_t i) {
    const std::uint32_t hash = hashOf(cellOf(vertices_[i]));
    Slot& slot = slots_[placeOf(hash)];
    if (slot.first == kNoVertex) ++used_;
    next_[i] = slot.first;
    slot = {hash, i};
    if (2 * used_ > slots_.size()) resize(2 * slots_.size());
  }

  /// Has the memory fetch what find(i) will look at.
  void expect(std::uint32_t i) const { __builtin_prefetch(&slots_[hashOf(cellOf(vertices_[i])) & mask_]); }

 private:
  struct Slot {
    std::uint32_t hash = 0, first = kNoVertex;
  };

  Cell cellOf(const dvec3& point) const {
    return {cellBelow(point.x * per_cell_), cellBelow(point.y * per_cell_), cellBelow(point.z * per_cell_)};
  }

  /// Where the chain of that hash begins, or would.
  std::size_t placeOf(std::uint32_t hash) const {
    std::size_t place = hash & mask_;
    while (slots_[place].first != kNoVertex && slots_[place].hash != hash) place = (place + 1) & mask_;
    return place;
  }

  std::uint32_t findIn(std::uint32_t hash, std::uint32_t i) const {
    std::uint32_t found = kNoVertex;
    for (std::uint32_t j = slots_[placeOf(hash)].first; j != kNoVertex; j = next_[j]) {
      if (glm::distance(vertices_[i], vertices_[j]) <= tolerance_) found = std::min(found, j);
    }
    return found;
  }

  void resize(std::size_t size) {
    std::vector<Slot> old(size);
    old.swap(slots_);
    mask_ = size - 1;
    for (const Slot& slot : old) {
      if (slot.first != kNoVertex) slots_[placeOf(slot.hash)] = slot;
    }
  }

  const std::vector<dvec3>& vertices_;
  double tolerance_;
  double per_cell_;
  std::vector<Slot> slots_;
  std::size_t mask_ = 0, used_ = 0;
  std::vector<std::uint32_t> next_;
};

/// In their order, each against those kept before it.
std::vector<std::uint32_t> mergedInTurn(const std::vector<dvec3>& vertices, double tolerance, std::uint32_t& merged) {
  const Bounds box = boundsOf(vertices);
  const dvec3 largest = box.isEmpty() ? dvec3(0.0) : glm::max(glm::abs(box.min), glm::abs(box.max));
  // Cells of some tolerances; not so small that their number would not fit an integer. Half: more vertices look into
  // several cells; twice: dense meshes have eight times the vertices in a cell.
  constexpr double kTolerances = 8.0;
  const double size = std::max({kTolerances * tolerance, 1e-12 * std::max({largest.x, largest.y, largest.z}), 1e-300});
  // Vertices looked ahead: what memory answers in the time of some of them. Half, twice: no effect.
  constexpr std::uint32_t kAhead = 12;
  VertexGrid grid(vertices, tolerance, size);
  std::vector<std::uint32_t> result(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    if (i + kAhead < vertices.size()) grid.expect(i + kAhead);
    const std::uint32_t found = grid.find(i);
    if (found == kNoVertex) {
      grid.keep(i);
    } else {
      ++merged;
    }
    result[i] = found == kNoVertex ? i : found;
  }
  return result;
}

/// As mergedInTurn(): vertices that have no other one near are kept and decide about none, so only the rest has to wait
/// its turn.
std::vector<std::uint32_t> mergedWhereCrowded(const std::vector<dvec3>& vertices, double tolerance,
                                              std::uint32_t& merged) {
  const std::vector<std::uint32_t> crowded = crowdedVertices(vertices, tolerance);
  std::vector<dvec3> places;
  places.reserve(crowded.size());
  for (const std::uint32_t v : crowded) places.push_back(vertices[v]);
  const std::vector<std::uint32_t> same = mergedInTurn(places, tolerance, merged);
  std::vector<std::uint32_t> result;
  result.resize(vertices.size());
  std::iota(result.begin(), result.end(), 0u);
  for (std::size_t k = 0; k < crowded.size(); ++k) result[crowded[k]] = crowded[same[k]];
  return result;
}

}  // namespace

std::vector<std::uint32_t> mergedVertices(const std::vector<dvec3>& vertices, double tolerance,
                                          std::uint32_t* merged) {
  // Vertices from which on looking for crowds first is quicker. Half, twice: no effect.
  constexpr std::size_t kMany = 20'000;
  std::uint32_t count = 0;
  auto result = vertices.size() < kMany ? mergedInTurn(vertices, tolerance, count)
                                        : mergedWhereCrowded(vertices, tolerance, count);
  if (merged) *merged = count;
  return result;
}

}  // namespace hapticell::geometry
