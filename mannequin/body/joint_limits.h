// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// The coupled limits of a ball joint (glenohumeral or hip): a star-shaped cone about the middle of the range for the
/// direction of the bone, and a range of twist about the bone. Separate limits of Euler angles would reject a quarter
/// of the postures that an arm can take.
///
/// Direction and twist are measured from the middle direction c: swing is the least rotation from c to the direction d
/// of the bone, its angle is rho, its direction about c is psi; twist is the remaining rotation, 0 for an arm that
/// swings from hanging straight to c and on to d. Shoulder: boundary through the AAOS figures (our own choice of
/// knots), twist -90 (external) .. 70 (internal). Hip: ellipse about 45 deg flexion and 7.5 deg abduction, half axes 75
/// and 37.5 deg, twist +-45. dofInfo() gives the clinical range of each such angle by itself, for information only:
/// these coupled limits apply.
enum class BallJoint : std::uint8_t { kShoulder, kHip };

/// True for the three angles of a shoulder or hip, whose limits are coupled.
bool isCoupled(Dof dof);

/// An orientation compared with the limits, rad.
struct BallState {
  double rho = 0.0;
  double psi = 0.0;
  double twist = 0.0;    ///< Internal positive.
  double rho_max = 0.0;  ///< At psi.
  double excess() const { return rho - rho_max; }
};

/// rad: -90 to 70 and +-45 degrees, the clinical ranges of rotation of the AAOS (see above). Half: natural postures of
/// arms are refused; twice: postures that nobody can take.
inline constexpr double kShoulderTwistLower = -0.5 * std::numbers::pi, kShoulderTwistUpper = 1.2217304763960306;
inline constexpr double kHipTwistLower = -0.7853981633974483, kHipTwistUpper = 0.7853981633974483;
double twistLower(BallJoint joint);
double twistUpper(BallJoint joint);

/// Of the bone's frame in its parent's (clavicle or pelvis), `R_PS`.
BallState ballState(BallJoint joint, Side side, const dmat3& R_PS);

/// The amount outside the limits (rad, 0 inside): the larger of cone and twist.
double ballViolation(BallJoint joint, Side side, const dmat3& R_PS);

/// The orientation with rho and twist moved inside the limits (psi kept); unchanged if it is inside.
dmat3 clampBall(BallJoint joint, Side side, const dmat3& R_PS);

/// The orientation of a state: the inverse of ballState().
dmat3 ballRotation(BallJoint joint, Side side, double rho, double psi, double twist);

/// Three axes in the parent's frame in which the coupled limits are simple bounds: a small rotation about `cone`
/// changes (rho - rho_max) at the rate `cone_rate` and not the twist, one about `free` changes neither (to first
/// order), one about `bone` changes only the twist, at rate 1 (internal positive).
struct BallAxes {
  dvec3 cone, free, bone;
  double cone_rate = 1.0;
  BallState state;
};
BallAxes ballAxes(BallJoint joint, Side side, const dmat3& R_PS);

/// The girdle's share of raising the arm, rad, for the elevation of the arm relative to the thorax (0 hanging): the 5.6
/// deg at rest belong to the zero posture, so 0.22 of the part above 30 deg (measured on a recorded arm, r^2 0.96).
double girdleElevation(double arm_elevation);
/// Protraction that goes with the arm's forward component (-1..1): about 10 deg.
double girdleProtraction(double forward);

}  // namespace hapticell::mannequin
