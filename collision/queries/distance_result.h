// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

/// m: surfaces nearer than this touch: distance 0, colliding. Ten thousand times the rounding at 1 m, a thousandth of
/// kLeastClearance. Half and twice: still between these two.
inline constexpr double kTouchingDistance = 1e-9;

/// Minimum distance of two colliders A and B, with the equation |p_WA - p_WB| = distance, and
/// p_WA = p_WB + distance * nhat_BA_W where the distance is positive.
///
/// Solids: a mesh (or one of its connected pieces) that lies completely inside a closed piece of the other also
/// collides: `colliding` and `contained` are true, the distance is 0, and p_WA == p_WB is a point of the inner surface.
struct DistanceResult {
  double distance = 0.0;           ///< Metres; 0 when touching or intersecting.
  bool colliding = false;          ///< Surfaces touch or intersect, or one lies inside the other (`contained`).
  bool contained = false;          ///< Surfaces are apart, but one mesh, or a piece of it, is inside the other's solid.
  dvec3 p_WA{0.0};                 ///< Nearest point on A; equal to p_WB, a common point, when colliding.
  dvec3 p_WB{0.0};                 ///< Nearest point on B.
  dvec3 nhat_BA_W{0.0, 0.0, 1.0};  ///< Unit, from B towards A; when colliding, of the intersected triangle of B.
  std::uint32_t triangle_A = 0;    ///< Triangle of A's mesh that holds p_WA.
  std::uint32_t triangle_B = 0;    ///< Triangle of B's mesh that holds p_WB.
  bool beyond_limit = false;  ///< Nothing nearer than the query's limit: distance is then that limit, points unset.
};

}  // namespace hapticell::collision
