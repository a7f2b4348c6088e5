// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "geometry/shapes/vector.h"
#include "kinematics/model/arm_axes.h"
#include "kinematics/kernels/kernels.h"
#include "kinematics/model/robot_class.h"

namespace hapticell::kinematics {

/// All solutions of one arm in closed form (or, for offset wrists, by a search that misses none), limits left out.
///
/// Exact for the nominal arm: the axes as given with what is nearly parallel, square or meeting taken as exactly so. At
/// zero the nominal and the true tip coincide. Const functions allocate nothing and run in any thread.
class ClosedForm {
 public:
  virtual ~ClosedForm() = default;

  /// Solutions come in so many groups of four.
  virtual int groups() const { return 2; }

  /// Free parameters: 0 for six joints; 1 for seven, see redundancyAt().
  virtual int redundancy() const { return 0; }

  /// The tip at R_BT, p_BT in the frame that the arm's axes were given in (slides in front at zero). `redundant` is the
  /// free parameter, `previous` the arm's joints before: a joint that the pose leaves free keeps its place.
  virtual void solve(const dmat3& R_BT, const dvec3& p_BT, double redundant, const double* previous,
                     kernels::Solutions& solutions) const = 0;

  /// Solutions for kernels::kRingSize values of the free parameter all round, beginning with `first`, at once; false if
  /// this form does not support it.
  virtual bool ring(const dmat3& /*R_BT*/, const dvec3& /*p_BT*/, double /*first*/, const double* /*previous*/,
                    kernels::SwivelRing& /*ring*/) const {
    return false;
  }
  /// Those of one entry of a ring, as solve() gives them.
  virtual void ofRing(const kernels::SwivelRing& /*ring*/, int /*index*/, kernels::Solutions& /*solutions*/) const {}

  /// The free parameter (rad) of joint positions `q` that bring the tip to this pose: the swivel of the elbow, or joint
  /// 7.
  virtual double redundancyAt(const dmat3& /*R_BT*/, const dvec3& /*p_BT*/, const double* /*q*/) const { return 0.0; }
};

/// The closed form of a class for an arm that classify() put into it; null for kNumeric.
std::unique_ptr<const ClosedForm> makeClosedForm(RobotClass robot_class, const ArmAxes& axes);

/// The tip's pose taken to an arm's canonical frames: base frame 0 and last joint's frame N.
class CanonicalFrames {
 public:
  CanonicalFrames() = default;
  /// R_BN and p_BN are the pose of the last joint's frame at zero.
  CanonicalFrames(const ArmAxes& axes, const dmat3& R_B0, const dvec3& p_B0, const dmat3& R_BN, const dvec3& p_BN);
  void map(const dmat3& R_BT, const dvec3& p_BT, kernels::ArmPose& pose) const;

 private:
  kernels::ArmFrames frames_;
};

/// Walks through an arm's square axes at zero and reads the angles off them.
class FrameWalk {
 public:
  explicit FrameWalk(const dmat3& R) : R_(R) {}
  /// z along z_1, y along z_2 as far as it is square to that.
  FrameWalk(const dvec3& z_1, const dvec3& z_2);

  const dmat3& R() const { return R_; }
  const dvec3& x() const { return R_[0]; }
  const dvec3& y() const { return R_[1]; }
  const dvec3& z() const { return R_[2]; }
  double turnYTo(const dvec3& z);  ///< Turns about y until z points there as far as it can; the angle.
  double turnZTo(const dvec3& y);  ///< Turns about z until y points there as far as it can; the angle.
  void turnX(double angle);

 private:
  dmat3 R_;
};

}  // namespace hapticell::kinematics
