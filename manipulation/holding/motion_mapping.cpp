// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/motion_mapping.h"

#include <algorithm>
#include <cmath>

#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

/// Of SO(3): how the turn exp(theta) changes with its rotation vector, J = I + (1 - cos t)/t^2 [theta] + (t - sin
/// t)/t^3 [theta]^2 (T. Barfoot, "State Estimation for Robotics", 2017, 7.1.5).
dmat3 leftJacobian(const dvec3& theta) {
  const dmat3 cross(dvec3(0, theta.z, -theta.y), dvec3(-theta.z, 0, theta.x), dvec3(theta.y, -theta.x, 0));
  const double t = glm::length(theta);
  if (t < 1e-4) return dmat3(1.0) + 0.5 * cross + (1.0 / 6.0) * (cross * cross);
  return dmat3(1.0) + ((1.0 - std::cos(t)) / (t * t)) * cross + ((t - std::sin(t)) / (t * t * t)) * (cross * cross);
}

}  // namespace

dquat deviceAxes(AxesMode mode, const Pose& X_WCamera, const Pose& X_WF) {
  if (mode == AxesMode::kFrame) return X_WF.q;
  if (mode == AxesMode::kCell) return {1.0, 0.0, 0.0, 0.0};
  // Columns: where the device's right, away and up point to in the camera's frame.
  const dmat3 R_CameraD(dvec3(1.0, 0.0, 0.0), dvec3(0.0, 0.0, -1.0), dvec3(0.0, 1.0, 0.0));
  return glm::normalize(X_WCamera.q * glm::quat_cast(R_CameraD));
}

double screenScale(double visible_width, double workspace_width) {
  if (!(visible_width > 0.0) || !(workspace_width > 0.0)) return 1.0;
  return visible_width / workspace_width;
}

void MotionMapping::setScale(double scale) {
  if (std::isfinite(scale)) scale_ = std::clamp(scale, 1e-3, 1e3);
}

void MotionMapping::setFilter(bool translates, bool rotates) {
  translates_ = translates;
  rotates_ = rotates;
}

void MotionMapping::anchor(const Pose& X_DA, const Pose& X_WA) {
  X_DA_ = X_DA;
  X_WA_ = X_WA;
  bend_ = dmat3(1.0);
}

void MotionMapping::lookFrom(const Pose& X_DP) {
  const dvec3 theta = difference(X_DP, X_DA_).angular;
  // Where turning about some axis is hidden, what is left of it is mapped as at the anchor.
  const bool plain = rotation_scale_ == 1.0 || turned_ != dvec3(1.0);
  bend_ = plain ? dmat3(1.0) : leftJacobian(rotation_scale_ * theta) * glm::inverse(leftJacobian(theta));
}

void MotionMapping::setRotationScale(double scale) {
  if (std::isfinite(scale)) rotation_scale_ = std::clamp(scale, 0.01, 10.0);
}

Twist MotionMapping::toCell(const Twist& motion_D) const {
  return scaled({motion_D.linear, bend_ * motion_D.angular});
}

Twist MotionMapping::toDevice(const Twist& motion_W) const {
  const Twist motion_D = unscaled(motion_W);
  return {motion_D.linear, glm::inverse(bend_) * motion_D.angular};
}

Twist MotionMapping::scaled(const Twist& motion_D) const {
  return {translates_ ? scale_ * (q_WD_ * (kept_ * motion_D.linear)) : dvec3(0.0),
          rotates_ ? rotation_scale_ * (q_WD_ * (turned_ * motion_D.angular)) : dvec3(0.0)};
}

Twist MotionMapping::unscaled(const Twist& motion_W) const {
  const dquat q_DW = glm::conjugate(q_WD_);
  return {translates_ ? kept_ * (q_DW * motion_W.linear) / scale_ : dvec3(0.0),
          rotates_ ? turned_ * (q_DW * motion_W.angular) / rotation_scale_ : dvec3(0.0)};
}

void MotionMapping::turn(const dquat& q_W, const Pose& X_DP) {
  const dquat since = toCell(X_DP).q * glm::conjugate(X_WA_.q);
  X_WA_.q = glm::normalize(glm::conjugate(since) * q_W * since * X_WA_.q);
}

Pose MotionMapping::toCell(const Pose& X_DP) const {
  return displaced(X_WA_, scaled(difference(X_DP, X_DA_)));
}

Pose MotionMapping::toDevice(const Pose& X_WM, const Pose& X_DNear) const {
  const Pose X_DP = displaced(X_DA_, unscaled(difference(X_WM, X_WA_)));
  const dvec3 kept = translates_ ? kept_ : dvec3(0.0);
  const dvec3 p = kept * X_DP.p + (dvec3(1.0) - kept) * X_DNear.p;
  if (!rotates_ || turned_ == dvec3(1.0)) return {p, rotates_ ? X_DP.q : X_DNear.q};
  const dvec3 hidden = (dvec3(1.0) - turned_) * difference(X_DNear, X_DA_).angular;
  return {p, displaced(X_DA_, {dvec3(0.0), turned_ * difference(X_DP, X_DA_).angular + hidden}).q};
}

haptic::Vector6 MotionMapping::gradientToDevice(const haptic::Vector6& a_W) const {
  const dquat q_DW = glm::conjugate(q_WD_);
  const dvec3 linear = translates_ ? kept_ * (q_DW * dvec3(a_W[0], a_W[1], a_W[2])) : dvec3(0.0);
  const dvec3 turn_D = glm::transpose(bend_) * (turned_ * (q_DW * dvec3(a_W[3], a_W[4], a_W[5])));
  const dvec3 angular = rotates_ ? (rotation_scale_ / scale_) * turn_D : dvec3(0.0);
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}

void MotionMapping::toDevice(haptic::Constraint& constraint_W) const {
  constraint_W.gap /= scale_;
  constraint_W.trim_gap /= scale_;
  constraint_W.gradient = gradientToDevice(constraint_W.gradient);
  constraint_W.trim_gradient = gradientToDevice(constraint_W.trim_gradient);
  // xi_W = S xi_D with S = diag(scale R_WD K, rotation scale R_WD bend): B_D = S' B_W S / scale.
  const dmat3 R_DW = glm::mat3_cast(glm::conjugate(q_WD_));
  const dmat3 R_WD = glm::transpose(R_DW);
  Blocks blocks = blocksOf(constraint_W.curvature);
  const double linear = translates_ ? 1.0 : 0.0;
  const double angular = rotates_ ? 1.0 : 0.0;
  const dmat3 K = dmat3(dvec3(kept_.x, 0, 0), dvec3(0, kept_.y, 0), dvec3(0, 0, kept_.z));
  const dmat3 T = dmat3(dvec3(turned_.x, 0, 0), dvec3(0, turned_.y, 0), dvec3(0, 0, turned_.z));
  blocks.linear = (linear * scale_) * (K * R_DW * blocks.linear * R_WD * K);
  blocks.mixed = (linear * angular * rotation_scale_) * (K * R_DW * blocks.mixed * R_WD * T * bend_);
  blocks.angular = (angular * rotation_scale_ * rotation_scale_ / scale_) *
                   (glm::transpose(bend_) * T * R_DW * blocks.angular * R_WD * T * bend_);
  constraint_W.curvature = symmetricOf(blocks);
}

}  // namespace hapticell::manipulation
