// SPDX-License-Identifier: Apache-2.0
#include "collision/pieces/gauss_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hapticell::collision {
namespace {

/// Edge of a cell, the sphere's radius being 1: 11 deg. Half: arcs over 5 deg no longer fit a cell and are tested one
/// by one; twice: four times the arcs of a cell.
constexpr double kCell = 0.2;
constexpr double kNarrow = 0.5 * kCell - 1e-6;  // farthest end of an arc from its middle that the cells are made for

struct Arc {
  dvec3 middle;
  bool narrow = false;
};

/// The chord lies at most as far from its middle as its ends, and the arc hardly farther: by 1 - cos, 0.005 here.
Arc arcOf(const dvec3& n0, const dvec3& n1) {
  const dvec3 middle = 0.5 * (n0 + n1);
  return {middle, 0.5 * glm::length(n1 - n0) + 0.006 < kNarrow};
}

std::array<int, 3> cellOf(const dvec3& p) {
  const auto index = [](double x) { return static_cast<int>(std::floor((x + 2.0) / kCell)); };
  return {index(p.x), index(p.y), index(p.z)};
}

std::uint32_t keyOf(int x, int y, int z) {
  return static_cast<std::uint32_t>((x * 64 + y) * 64 + z);
}

}  // namespace

void GaussGrid::add(const dvec3& n0, const dvec3& n1) {
  const Arc arc = arcOf(n0, n1);
  const auto [x, y, z] = cellOf(arc.middle);
  (arc.narrow ? cells_[keyOf(x, y, z)] : wide_).push_back(count_++);
}

void GaussGrid::crossing(const dvec3& n0, const dvec3& n1, std::vector<std::uint32_t>& found) const {
  const Arc arc = arcOf(n0, n1);
  if (!arc.narrow) {
    found.resize(count_);
    std::iota(found.begin(), found.end(), 0U);
    return;
  }
  found = wide_;
  const auto [x, y, z] = cellOf(arc.middle);
  for (int i = 0; i < 27; ++i) {
    const auto cell = cells_.find(keyOf(x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1));
    if (cell != cells_.end()) found.insert(found.end(), cell->second.begin(), cell->second.end());
  }
  std::sort(found.begin(), found.end());
}

}  // namespace hapticell::collision
