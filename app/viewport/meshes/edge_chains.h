// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::app {

/// Border edges of a face as vertex pairs, split into what a designer would call edges.
struct EdgeChain {
  std::vector<std::uint32_t> vertices;  ///< In order; a closed chain repeats the first one at its end.
  bool is_line = false;
  bool is_circle = false;  ///< A full circle or an arc.
  dvec3 center{0.0};       ///< Lines: the middle. Circles: the centre.
  dvec3 axis{0.0, 0.0, 1.0};
  double radius = 0.0;
};

using EdgeEnds = std::array<std::uint32_t, 2>;

/// Splits `edges` over `vertices` (m) into chains: they end at corners (more or fewer than two edges, or a turn over 35
/// degrees) and where a line meets an arc. Each edge is in one chain.
std::vector<EdgeChain> edgeChains(const std::vector<EdgeEnds>& edges, const std::vector<dvec3>& vertices);

}  // namespace hapticell::app
