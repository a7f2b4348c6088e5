// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// How many separate places of A and B (placed by X_AB) are within `zone` (m) of each other.
///
/// All pairs of triangles within the zone count; two of them belong to the same place when they share a corner on A and
/// a corner on B, and so on from pair to pair. A box standing on a table is one place, a table on a floor four. At most
/// `most_pairs` pairs are examined. Any thread; allocates.
std::size_t countContactRegions(const MeshCollider& a, const MeshCollider& b, const Pose& X_AB, double zone,
                                std::size_t most_pairs = 1u << 18);

}  // namespace hapticell::collision
