// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

/// Arcs between two unit normals (an edge's two faces on the Gauss sphere), in a grid for searching by position. Two
/// edges make a face of the Minkowski difference only if their arcs cross: for round bodies, a few pairs out of
/// millions.
class GaussGrid {
 public:
  /// Adds the arc from n0 to n1 with the next number, counting from 0.
  void add(const dvec3& n0, const dvec3& n1);

  /// Numbers of all arcs that may cross this one (some do not), in ascending order.
  void crossing(const dvec3& n0, const dvec3& n1, std::vector<std::uint32_t>& found) const;

 private:
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> cells_;
  std::vector<std::uint32_t> wide_;  ///< Arcs too long for the cells.
  std::uint32_t count_ = 0;
};

}  // namespace hapticell::collision
