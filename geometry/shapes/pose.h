// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell {

/// A small motion or a difference of two poses: a translation (m) and a rotation vector (axis times angle, rad).
struct Twist {
  dvec3 linear{0.0};
  dvec3 angular{0.0};
};

/// The rigid pose X_AB of a frame B in a frame A.
///
/// Stays orthonormal by construction: the rotation is a unit quaternion, never a matrix. Monogram notation: with
/// `X_AB` and `X_BC`, `X_AC = X_AB * X_BC`, and a point `p_BQ` given in B is `p_AQ = X_AB * p_BQ` in A.
struct Pose {
  dvec3 p{0.0};                 ///< Position of B's origin in A, metres.
  dquat q{1.0, 0.0, 0.0, 0.0};  ///< Rotation from B to A, unit, w first.

  static Pose identity() { return {}; }
  static Pose translation(const dvec3& p_AB) { return {p_AB, dquat(1.0, 0.0, 0.0, 0.0)}; }
  static Pose rotation(const dquat& q_AB) { return {dvec3(0.0), glm::normalize(q_AB)}; }

  Pose inverse() const;
  dmat3 R() const { return glm::mat3_cast(q); }

  /// Maps a free vector (a direction, a force) from B to A.
  dvec3 rotate(const dvec3& v_B) const { return q * v_B; }

  /// True when all seven numbers are finite, p within 1e12 m and the quaternion a unit one within 1e-6.
  bool isValid() const;
};

/// X_AC = X_AB * X_BC; the quaternion is normalised again.
Pose operator*(const Pose& X_AB, const Pose& X_BC);

/// p_AQ = X_AB * p_BQ.
dvec3 operator*(const Pose& X_AB, const dvec3& p_BQ);

/// The rotation vector (axis times angle in [0, pi], rad) of a unit quaternion; its sign does not matter.
dvec3 rotationVector(const dquat& q);

/// The unit quaternion of a rotation vector (rad).
dquat quaternionFromRotationVector(const dvec3& rotation_vector);

/// The motion from X_AB to X_AC, expressed in A: linear = p_AC - p_AB, angular = rotation vector of R_AC * R_AB^-1.
Twist difference(const Pose& X_AC, const Pose& X_AB);

/// Applies a difference: displaced(X_AB, difference(X_AC, X_AB)) equals X_AC.
Pose displaced(const Pose& X_AB, const Twist& motion_A);

/// The pose at `s` in [0, 1] on the motion from X_A0 to X_A1: origin on a straight line, rotation about a fixed axis.
Pose interpolate(const Pose& X_A0, const Pose& X_A1, double s);

}  // namespace hapticell
