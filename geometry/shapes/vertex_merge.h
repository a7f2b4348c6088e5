// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::geometry {

/// For each vertex, the index of the vertex that replaces it in weld(): the first kept vertex within `tolerance` (m),
/// or the vertex itself. Changes nothing. `merged`, if given, is how many are replaced.
std::vector<std::uint32_t> mergedVertices(const std::vector<dvec3>& vertices, double tolerance,
                                          std::uint32_t* merged = nullptr);

}  // namespace hapticell::geometry
