// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// The linkage of a Phantom: waist, shoulder and elbow, the elbow driven through a parallelogram (so its angle is
/// measured from the vertical, not from the upper arm).
///
/// In the arm's own frame A (origin at the shoulder, x forwards to the user, z up)
///   x = cos q1 (l1 cos q2 + l2 sin q3), y = sin q1 (l1 cos q2 + l2 sin q3), z = l1 sin q2 - l2 cos q3
/// (M. Cavusoglu, D. Feygin, F. Tendick, "A critical study of the mechanical and electrical properties of the PHANToM
/// haptic interface", 2002). The device frame D has its origin in the middle of the workspace, 0.85 of both links from
/// the shoulder; its x is A's y, its y is -A's x.
class PhantomArm {
 public:
  /// Link lengths in metres, both positive.
  PhantomArm(double upper_arm, double forearm);

  /// Tip position in D of the joints (q1, q2, q3), rad.
  dvec3 tip(const dvec3& joints) const;
  /// Joints of a tip position in D. For a tip out of reach, the joints of the nearest reachable one on the same ray.
  dvec3 joints(const dvec3& p_D) const;
  /// Jacobian of tip() at the joints: column i is the tip's motion in D with joint i, m/rad.
  dmat3 jacobian(const dvec3& joints) const;

  double reach() const { return upper_arm_ + forearm_; }
  /// The shoulder in D.
  dvec3 shoulder() const;

 private:
  double upper_arm_;
  double forearm_;
};

}  // namespace hapticell::haptic
