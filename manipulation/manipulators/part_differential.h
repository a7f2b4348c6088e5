// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::manipulation {

/// How a rigid part of the manipulated entity follows a small motion xi of the moved frame M, to second order.
///
/// xi = (dx, dy, dz, rx, ry, rz): translation of M's origin and rotation vector, both in the cell W, from the reference
/// pose. The part's origin Po moves by  sum_i velocity[i] xi_i + 1/2 sum_ij acceleration[ij] xi_i xi_j  and turns
/// likewise; `acceleration` holds the symmetric bilinear form packed as an upper triangle (see packedIndex()).
struct PartDifferential {
  dvec3 p_WPo{0.0};
  std::array<Twist, 6> velocity{};
  std::array<Twist, 21> acceleration{};
};

/// The differential of a part that moves rigidly with M (a solid, a robot moved by its base).
PartDifferential rigidDifferential(const dvec3& p_WMo, const dvec3& p_WPo);

/// Velocity of the part's point at `p_WQ` for a unit motion along xi_i, and the bilinear second-order term of (i, j).
dvec3 pointVelocity(const PartDifferential& part, const dvec3& p_WQ, std::size_t i);
dvec3 pointAcceleration(const PartDifferential& part, const dvec3& p_WQ, std::size_t i, std::size_t j);

/// f = gap + n . e + 1/2 e' M e for the displacement e of a point Q that is fixed to the part.
struct PointCondition {
  dvec3 p_WQ{0.0};
  dvec3 nhat_W{0.0, 0.0, 1.0};
  double gap = 0.0;
  dmat3 M{0.0};  ///< Curvature of the surface that it meets, 1/m, positive where that is convex.
  /// The normal is fixed to the part: its face, curved by M, meets a corner of the obstacle at p_WQ.
  bool normal_moves = false;
};

/// The same as gap, gradient and curvature over xi: a_i = n . v_i and B_ij = v_i . M v_j + n . a_ij (chain rule).
void applyCondition(const PartDifferential& part, const PointCondition& condition, haptic::Constraint& constraint_W);

/// The same to first order only, added to a trim.
void applyTrim(const PartDifferential& part, const PointCondition& condition, haptic::Constraint& constraint_W);

}  // namespace hapticell::manipulation
