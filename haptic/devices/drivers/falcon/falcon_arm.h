// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/shapes/vector.h"

namespace hapticell::driver {

/// The Falcon's delta linkage: three motors, each with an arm and a parallelogram, hold a grip that only translates.
///
/// R. E. Stamper, "A Three Degree of Freedom Parallel Manipulator with Only Translational Degrees of Freedom", 1997,
/// with the lengths that libnifalcon gives for the Falcon. Falcon's own frame F: origin in the middle of its base, x
/// right, y up, z to the user, metres; motor angles in radians, 0 where an arm points straight outwards, positive to
/// the user.
class FalconArm {
 public:
  /// Motor angles that bring the grip to p_F; empty if a leg does not reach it.
  static std::optional<dvec3> angles(const dvec3& p_F);

  /// The grip's position of motor angles, by Newton's method on angles() from `start`, to 1e-9 m; empty if it does not
  /// converge (impossible angles).
  static std::optional<dvec3> position(const dvec3& angles, const dvec3& start);

  /// Jacobian dp/dangle at p_F, column i for motor i, m/rad. Empty if a leg does not reach or the linkage is singular.
  static std::optional<dmat3> jacobian(const dvec3& p_F);

  /// Motor torques that exert `force_F` on the hand: J^T F, N m.
  static dvec3 torques(const dmat3& jacobian, const dvec3& force_F) { return glm::transpose(jacobian) * force_F; }

  /// The middle of the workspace in F.
  static dvec3 middle() { return {0.0, 0.0, 0.125}; }

  /// Motor angle for an encoder count.
  static double angleOf(int count);
  /// Encoder count for an angle, not rounded.
  static double countOf(double angle);
};

/// From F to the device frame D (x right, y away, z up, origin in the middle), and back for free vectors.
dvec3 falconToDevice(const dvec3& p_F);
dvec3 deviceToFalcon(const dvec3& v_D);

}  // namespace hapticell::driver
