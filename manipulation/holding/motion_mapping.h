// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::manipulation {

/// The axes along which the hand moves the entity (section 5.4 of the paper).
enum class AxesMode {
  kScreen,  ///< What the user sees: right is right, up is up, away is into the picture (X normal to it, Y and Z in it).
  kCell,    ///< The cell's own axes: x right, y away, z up.
  kFrame,   ///< The axes of a frame that the user names.
};

/// Rotation R_WD that turns a motion of the hand in the device frame D (x right, y away, z up) into one of the cell W.
///
/// `X_WCamera` looks along its -z with x to the right and y up; used by kScreen only. `X_WF` is used by kFrame only.
dquat deviceAxes(AxesMode mode, const Pose& X_WCamera, const Pose& X_WF);

/// Scale of the level "screen": the visible width at the depth of the focus, divided by the width of the device's
/// workspace.
double screenScale(double visible_width, double workspace_width);

/// Turns motions of the stylus into motions of the moved frame M in the cell and back.
///
/// With an anchor (X_DA, X_WA) set at grab or at the end of a clutch: p_WM = p_WA + scale R_WD K (p_DP - p_DA), R_WM =
/// exp(rotation scale R_WD rotvec(R_DP R_DA^-1)) R_WA, where K keeps the device's allowed axes. The default rotation
/// scale is 1. A value; used by the manipulation thread.
class MotionMapping {
 public:
  const dquat& axes() const { return q_WD_; }
  double scale() const { return scale_; }

  void setAxes(const dquat& q_WD) { q_WD_ = glm::normalize(q_WD); }
  /// Metres in the cell per metre of hand motion; limited to 1e-3 .. 1e3; values that are not finite are ignored.
  void setScale(double scale);
  /// Switches translation or rotation by the hand on or off.
  void setFilter(bool translates, bool rotates);
  /// Allows only motions along these of the device's axes: one (a line), two (a plane), all three.
  void setAxisFilter(bool x, bool y, bool z) { kept_ = {x ? 1.0 : 0.0, y ? 1.0 : 0.0, z ? 1.0 : 0.0}; }
  /// Allows only rotation about these of the device's axes (of the rotation vector since the anchor).
  void setTurnFilter(bool x, bool y, bool z) { turned_ = {x ? 1.0 : 0.0, y ? 1.0 : 0.0, z ? 1.0 : 0.0}; }
  /// Radians of the entity per radian of the wrist; limited to 0.01 .. 10; values that are not finite are ignored.
  void setRotationScale(double scale);
  double rotationScale() const { return rotation_scale_; }
  bool translates() const { return translates_; }
  bool rotates() const { return rotates_; }
  /// No axis of translation is switched off.
  bool translatesFreely() const { return translates_ && kept_ == dvec3(1.0); }

  /// From now on the stylus at X_DA corresponds to the moved frame at X_WA. Call it after setAxes, setScale and
  /// setFilter.
  void anchor(const Pose& X_DA, const Pose& X_WA);

  /// Moves the anchor back by `motion_D`, so that the held entity moves on by it.
  void drift(const dvec3& motion_D) { X_DA_.p -= motion_D; }

  /// Moves the anchor so that the moved frame's target for any stylus pose is moved by `way_W` (m, world).
  void shift(const dvec3& way_W) { X_WA_.p += way_W; }

  /// Turns the anchor so that the moved frame's target for the stylus (or proxy) at X_DP is turned by `q_W` about its
  /// origin.
  void turn(const dquat& q_W, const Pose& X_DP);

  /// The target of the moved frame for the stylus (or proxy) at X_DP.
  Pose toCell(const Pose& X_DP) const;
  /// The stylus pose that corresponds to X_WM; components removed by a filter come from `X_DNear`. Inverse of toCell().
  Pose toDevice(const Pose& X_WM, const Pose& X_DNear) const;

  /// Sets the stylus (or proxy) orientation X_DP for which small motions and constraints are mapped; anchor() sets its
  /// own. Scaled rotations do not add up as vectors, so for a rotation scale other than 1 the map depends on it.
  void lookFrom(const Pose& X_DP);

  /// A small motion of the stylus as one of the moved frame, and back (filtered parts become zero).
  Twist toCell(const Twist& motion_D) const;
  Twist toDevice(const Twist& motion_W) const;

  /// Turns f(xi_W) in metres of the cell into f(xi_D) in metres of the hand: gap, trim and gradients by 1 / scale of
  /// their length, directions into D. A contact's gradient keeps unit length in its linear part.
  void toDevice(haptic::Constraint& constraint_W) const;

 private:
  haptic::Vector6 gradientToDevice(const haptic::Vector6& a_W) const;
  /// The whole difference from the anchor, scaled, and back.
  Twist scaled(const Twist& motion_D) const;
  Twist unscaled(const Twist& motion_W) const;

  dquat q_WD_{1.0, 0.0, 0.0, 0.0};
  double scale_ = 1.0;
  bool translates_ = true;
  bool rotates_ = true;
  dvec3 kept_{1.0};    ///< 1 for an allowed axis, else 0.
  dvec3 turned_{1.0};  ///< The same for rotation.
  double rotation_scale_ = 1.0;
  Pose X_DA_;
  Pose X_WA_;
  dmat3 bend_{1.0};  ///< The part of a small rotation's map that is not the scale, in D: the left Jacobian of exp(s
                     ///< theta) times the inverse of that of theta.
};

}  // namespace hapticell::manipulation
