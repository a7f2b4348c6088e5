// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closed_form/closed_form.h"

#include <cmath>
#include <numbers>

#include "kinematics/closed_form/offset_wrist.h"
#include "kinematics/closed_form/opw_geometry.h"
#include "kinematics/closed_form/scara.h"
#include "kinematics/closed_form/seven_reach.h"
#include "kinematics/closed_form/spherical_arm.h"

namespace hapticell::kinematics {

namespace {

dmat3 aboutX(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {1, 0, 0, 0, c, s, 0, -s, c};
}
dmat3 aboutY(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, 0, -s, 0, 1, 0, s, 0, c};
}
dmat3 aboutZ(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, s, 0, -s, c, 0, 0, 0, 1};
}

class OpwForm final : public ClosedForm {
 public:
  explicit OpwForm(const ArmAxes& axes) {
    const OpwGeometry geometry(axes);
    arm_ = geometry.arm;
    frames_ = geometry.frames;
  }
  void solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* previous,
             kernels::Solutions& solutions) const override {
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    kernels::table().opw(arm_, pose, previous, solutions);
  }

 private:
  kernels::OpwArm arm_{};
  CanonicalFrames frames_;
};

class UrForm final : public ClosedForm {
 public:
  explicit UrForm(const ArmAxes& axes) {
    FrameWalk walk(axes.axis_B[0], axes.axis_B[1]);
    const dmat3 R_B0 = walk.R();
    const dvec3 o1 = axes.origin_B[0];
    const dvec3 p_B0 = o1 + glm::dot(axes.origin_B[1] - o1, walk.z()) * walk.z();
    const dvec3 upper = axes.origin_B[2] - axes.origin_B[1], fore = axes.origin_B[3] - axes.origin_B[2];
    const dvec3 wrist = nearestPoint(axes, 3, 4), flange = nearestPoint(axes, 4, 5);
    arm_.a1 = glm::dot(axes.origin_B[1] - p_B0, walk.x());
    arm_.c2 = std::hypot(glm::dot(upper, walk.x()), glm::dot(upper, walk.z()));
    arm_.c3 = std::hypot(glm::dot(fore, walk.x()), glm::dot(fore, walk.z()));
    arm_.d4 = glm::dot(wrist - p_B0, walk.y());
    const double theta_2 = std::atan2(glm::dot(upper, walk.x()), glm::dot(upper, walk.z()));
    const double theta_23 = std::atan2(glm::dot(fore, walk.x()), glm::dot(fore, walk.z()));
    arm_.map.sign[2] = glm::dot(axes.axis_B[2], walk.y()) < 0.0 ? -1.0 : 1.0;
    arm_.map.sign[3] = glm::dot(axes.axis_B[3], walk.y()) < 0.0 ? -1.0 : 1.0;
    arm_.map.offset[1] = theta_2;
    arm_.map.offset[2] = theta_23 - theta_2;
    arm_.map.offset[3] = walk.turnYTo(axes.axis_B[4]) - theta_23;
    arm_.d5 = glm::dot(flange - wrist, walk.z());
    arm_.map.offset[4] = walk.turnZTo(axes.axis_B[5]);
    walk.turnX(-0.5 * std::numbers::pi);
    frames_ = CanonicalFrames(axes, R_B0, p_B0, walk.R(), flange);
  }
  void solve(const dmat3& R_BT, const dvec3& p_BT, double, const double* previous,
             kernels::Solutions& solutions) const override {
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    kernels::table().ur(arm_, pose, previous, solutions);
  }

 private:
  kernels::UrArm arm_{};
  CanonicalFrames frames_;
};

class SevenForm final : public ClosedForm {
 public:
  SevenForm(const ArmAxes& axes, bool srs) : srs_(srs) {
    FrameWalk walk(axes.axis_B[0], axes.axis_B[1]);
    const dmat3 R_B0 = walk.R();
    const dvec3 shoulder = nearestPoint(axes, 0, 1), wrist = nearestPoint(axes, 4, 5);
    arm_.map.offset[1] = walk.turnYTo(axes.axis_B[2]);
    arm_.map.offset[2] = walk.turnZTo(axes.axis_B[3]);
    // The point of axis 4 next to axis 3 is the elbow; along y of frame 3 it says nothing.
    const dvec3 elbow = srs ? nearestPoint(axes, 2, 3) : axes.origin_B[3];
    arm_.d3 = glm::dot(elbow - shoulder, walk.z());
    arm_.a4 = srs ? 0.0 : glm::dot(elbow - shoulder, walk.x());
    arm_.map.offset[3] = walk.turnYTo(axes.axis_B[4]);
    arm_.a5 = srs ? 0.0 : glm::dot(wrist - elbow, walk.x());
    arm_.d5 = glm::dot(wrist - elbow, walk.z());
    arm_.map.offset[4] = walk.turnZTo(axes.axis_B[5]);
    arm_.map.offset[5] = walk.turnYTo(axes.axis_B[6]);
    const dvec3 to_axis_7 = axes.origin_B[6] - wrist;
    arm_.a7 = srs ? 0.0 : glm::dot(to_axis_7, walk.x());
    frames_ = CanonicalFrames(axes, R_B0, shoulder, walk.R(), wrist + arm_.a7 * walk.x());
  }
  int redundancy() const override { return 1; }
  void solve(const dmat3& R_BT, const dvec3& p_BT, double redundant, const double* previous,
             kernels::Solutions& solutions) const override {
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    const auto kernel = srs_ ? kernels::table().srs : kernels::table().panda;
    kernel(arm_, pose, redundant, previous, solutions);
  }
  bool ring(const dmat3& R_BT, const dvec3& p_BT, double first, const double* previous,
            kernels::SwivelRing& ring) const override {
    if (!srs_) return false;
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    kernels::table().srsRing(arm_, pose, first, previous, ring);
    return true;
  }
  void ofRing(const kernels::SwivelRing& ring, int index, kernels::Solutions& solutions) const override {
    kernels::table().srsOfRing(arm_, ring, index, solutions);
  }
  bool provesNone(const dmat3& R_BT, const dvec3& p_BT, const kernels::JointBounds& bounds, double from,
                  double to) const override {
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    return SevenReach(arm_, bounds, pose, srs_).provesNone(from, to);
  }
  double redundancyAt(const dmat3& R_BT, const dvec3& p_BT, const double* q) const override {
    if (!srs_) return q[6];
    kernels::ArmPose pose;
    frames_.map(R_BT, p_BT, pose);
    const dvec3 p(pose.p[0], pose.p[1], pose.p[2]);
    const double theta_1 = q[0] + arm_.map.offset[0], theta_2 = q[1] + arm_.map.offset[1];
    const dvec3 z3(std::cos(theta_1) * std::sin(theta_2), std::sin(theta_1) * std::sin(theta_2), std::cos(theta_2));
    const double flat = std::hypot(p.x, p.y), r = glm::length(p);
    if (r < 1e-12) return 0.0;
    const dvec3 w = p / r;
    const bool upright = flat < 1e-12 * r;
    const dvec3 side = upright ? dvec3(0, 1, 0) : dvec3(-p.y / flat, p.x / flat, 0);
    return std::atan2(glm::dot(z3, side), glm::dot(z3, glm::cross(w, side)));
  }

 private:
  bool srs_;
  kernels::SevenArm arm_{};
  CanonicalFrames frames_;
};

}  // namespace

FrameWalk::FrameWalk(const dvec3& z_1, const dvec3& z_2) : R_(1.0) {
  const dvec3 y = glm::normalize(z_2 - glm::dot(z_2, z_1) * z_1);
  R_ = dmat3(glm::cross(y, z_1), y, z_1);
}

double FrameWalk::turnYTo(const dvec3& z) {
  const double angle = std::atan2(glm::dot(z, R_[0]), glm::dot(z, R_[2]));
  R_ = R_ * aboutY(angle);
  return angle;
}

double FrameWalk::turnZTo(const dvec3& y) {
  const double angle = std::atan2(-glm::dot(y, R_[0]), glm::dot(y, R_[1]));
  R_ = R_ * aboutZ(angle);
  return angle;
}

void FrameWalk::turnX(double angle) {
  R_ = R_ * aboutX(angle);
}

CanonicalFrames::CanonicalFrames(const ArmAxes& axes, const dmat3& R_B0, const dvec3& p_B0, const dmat3& R_BN,
                                 const dvec3& p_BN) {
  const dmat3 R_0B = glm::transpose(R_B0), R_TN = glm::transpose(axes.R_BT) * R_BN;
  const dvec3 p_TN = glm::transpose(axes.R_BT) * (p_BN - axes.p_BT);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      frames_.R_0B[column][row] = R_0B[column][row];
      frames_.R_TN[3 * row + column] = R_TN[column][row];
    }
    frames_.p_B0[row] = p_B0[row];
    frames_.p_TN[row] = p_TN[row];
  }
}

void CanonicalFrames::map(const dmat3& R_BT, const dvec3& p_BT, kernels::ArmPose& pose) const {
  kernels::table().map(frames_, &R_BT[0].x, &p_BT.x, pose);
}

OpwGeometry::OpwGeometry(const ArmAxes& axes) {
  FrameWalk walk(axes.axis_B[0], axes.axis_B[1]);
  R_B0 = walk.R();
  const dvec3 o1 = axes.origin_B[0], o3 = axes.origin_B[2];
  p_B0 = o1 + glm::dot(axes.origin_B[1] - o1, walk.z()) * walk.z();
  const dvec3 upper = o3 - axes.origin_B[1];
  wrist_B = nearestPoint(axes, 3, 4);
  arm.a1 = glm::dot(axes.origin_B[1] - p_B0, walk.x());
  arm.b = glm::dot(wrist_B - p_B0, walk.y());
  arm.c2 = std::hypot(glm::dot(upper, walk.x()), glm::dot(upper, walk.z()));
  arm.map.sign[2] = glm::dot(axes.axis_B[2], walk.y()) < 0.0 ? -1.0 : 1.0;
  arm.map.offset[1] = std::atan2(glm::dot(upper, walk.x()), glm::dot(upper, walk.z()));
  arm.map.offset[2] = walk.turnYTo(axes.axis_B[3]) - arm.map.offset[1];
  const double a2 = glm::dot(wrist_B - o3, walk.x()), c3 = glm::dot(wrist_B - o3, walk.z());
  arm.k = std::hypot(a2, c3);
  arm.psi = std::atan2(a2, c3);
  arm.sin_psi = a2 / arm.k;
  arm.cos_psi = c3 / arm.k;
  arm.map.offset[3] = walk.turnZTo(axes.axis_B[4]);
  R_B4 = walk.R();
  arm.map.offset[4] = walk.turnYTo(axes.axis_B[5]);
  frames = CanonicalFrames(axes, R_B0, p_B0, walk.R(), wrist_B);
}

std::unique_ptr<const ClosedForm> makeClosedForm(RobotClass robot_class, const ArmAxes& axes) {
  switch (robot_class) {
    case RobotClass::kOpw:
      return std::make_unique<OpwForm>(axes);
    case RobotClass::kUr:
      return std::make_unique<UrForm>(axes);
    case RobotClass::kSrs:
      return std::make_unique<SevenForm>(axes, true);
    case RobotClass::kPanda:
      return std::make_unique<SevenForm>(axes, false);
    case RobotClass::kSphericalWrist:
      return makeSphericalArm(axes, false);
    case RobotClass::kSphericalBase:
      return makeSphericalArm(axes, true);
    case RobotClass::kOffsetWrist:
      return makeOffsetWrist(axes);
    case RobotClass::kScara:
      return makeScara(axes);
    case RobotClass::kNumeric:
      break;
  }
  return nullptr;
}

}  // namespace hapticell::kinematics
