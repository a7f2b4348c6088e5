// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::geometry {

/// The numbers, rising, of all vertices that have another one within `tolerance` (m), and of some that have none: after
/// exact sharing of corners mostly few. Looks at all of them on several threads; the answer is the same on any number
/// of them. Finite vertices, at most 500 million.
std::vector<std::uint32_t> crowdedVertices(const std::vector<dvec3>& vertices, double tolerance);

}  // namespace hapticell::geometry
