// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/shapes/vector.h"
#include "kinematics/kernels/kernels.h"
#include "kinematics/model/arm_axes.h"
#include "kinematics/model/robot_class.h"

namespace hapticell::kinematics {

/// All solutions of one arm in closed form (for offset wrists by a complete search), without regard to limits.
///
/// Exact for the nominal arm, in which axes that are nearly parallel, perpendicular or intersecting are taken as
/// exactly so. At zero, the nominal and the true tip coincide. Const functions allocate nothing and are thread-safe.
class ClosedForm {
 public:
  virtual ~ClosedForm() = default;

  /// Number of groups of four solutions.
  virtual int groups() const { return 2; }

  /// Number of free parameters: 0 for six joints; 1 for seven, see redundancyAt().
  virtual int redundancy() const { return 0; }

  /// Solves for the tip at R_BT, p_BT, in the frame in which the arm's axes were given (leading slides at zero).
  /// `redundant` is the free parameter, `previous` the previous joints of the arm: a joint that the pose does not
  /// determine keeps its value.
  virtual void solve(const dmat3& R_BT, const dvec3& p_BT, double redundant, const double* previous,
                     kernels::Solutions& solutions) const = 0;

  /// Solutions for kernels::kRingSize evenly spaced values of the free parameter, starting at `first`, in one call;
  /// false if this form does not support it.
  virtual bool ring(const dmat3& /*R_BT*/, const dvec3& /*p_BT*/, double /*first*/, const double* /*previous*/,
                    kernels::SwivelRing& /*ring*/) const {
    return false;
  }
  /// The solutions of one entry of a ring, as solve() gives them.
  virtual void ofRing(const kernels::SwivelRing& /*ring*/, int /*index*/, kernels::Solutions& /*solutions*/) const {}

  /// True: proven that no joint positions within `bounds` reach this pose with the free parameter in `from` to `to`
  /// (rad). False: not decided, as always for six joints.
  virtual bool provesNone(const dmat3& /*R_BT*/, const dvec3& /*p_BT*/, const kernels::JointBounds& /*bounds*/,
                          double /*from*/, double /*to*/) const {
    return false;
  }

  /// The free parameter (rad) of joint positions `q` that bring the tip to this pose: the swivel of the elbow, or joint
  /// 7.
  virtual double redundancyAt(const dmat3& /*R_BT*/, const dvec3& /*p_BT*/, const double* /*q*/) const { return 0.0; }
};

/// The closed form for the class of an arm that classify() recognised; null for kNumeric.
std::unique_ptr<const ClosedForm> makeClosedForm(RobotClass robot_class, const ArmAxes& axes);

/// Converts the pose of the tip to the canonical frames of an arm: base frame 0 and frame N of the last joint.
class CanonicalFrames {
 public:
  CanonicalFrames() = default;
  /// R_BN and p_BN are the pose of the last joint's frame at zero.
  CanonicalFrames(const ArmAxes& axes, const dmat3& R_B0, const dvec3& p_B0, const dmat3& R_BN, const dvec3& p_BN);
  void map(const dmat3& R_BT, const dvec3& p_BT, kernels::ArmPose& pose) const;

 private:
  kernels::ArmFrames frames_;
};

/// Follows an arm with perpendicular axes at zero and determines its angles.
class FrameWalk {
 public:
  explicit FrameWalk(const dmat3& R) : R_(R) {}
  /// z along z_1, y along the part of z_2 that is perpendicular to it.
  FrameWalk(const dvec3& z_1, const dvec3& z_2);

  const dmat3& R() const { return R_; }
  const dvec3& x() const { return R_[0]; }
  const dvec3& y() const { return R_[1]; }
  const dvec3& z() const { return R_[2]; }
  /// Rotates about y until z is as close as possible to this direction; returns the angle.
  double turnYTo(const dvec3& z);
  /// Rotates about z until y is as close as possible to this direction; returns the angle.
  double turnZTo(const dvec3& y);
  void turnX(double angle);

 private:
  dmat3 R_;
};

}  // namespace hapticell::kinematics
