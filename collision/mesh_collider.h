// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/triangle_mesh.h"

namespace hapticell::collision {

/// A triangle mesh prepared for proximity queries: its welded triangles and a tree of boxes over them, in the mesh's own
/// frame M. Immutable after build, so any thread may query it.
class MeshCollider;

/// Minimum distance of two colliders A and B, with the equation |p_WA - p_WB| = distance, and
/// p_WA = p_WB + distance * nhat_BA_W where the distance is positive.
struct DistanceResult {
  double distance = 0.0;             ///< Metres; 0 when touching or intersecting.
  bool colliding = false;            ///< Triangles intersect or touch (surface against surface; see `contained` in the query).
  dvec3 p_WA{0.0};                   ///< Nearest point on A; equal to p_WB, a common point, when colliding.
  dvec3 p_WB{0.0};
  dvec3 nhat_BA_W{0.0, 0.0, 1.0};    ///< Unit, from B towards A; when colliding, of the intersected triangle of B.
  std::uint32_t triangle_A = 0;
  std::uint32_t triangle_B = 0;
  bool beyond_limit = false;         ///< Nothing nearer than the query's limit: distance is then that limit, points unset.
};

}  // namespace hapticell::collision
