// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::geometry {

/// For each vertex the index of the first one that stands for it: the first kept vertex within `tolerance`, itself
/// where there is none. What weld() merges, without changing anything.
std::vector<std::uint32_t> mergedVertices(const std::vector<dvec3>& vertices, double tolerance);

}  // namespace hapticell::geometry
