// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/limb_inverse.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mannequin/body/joint_limits.h"
#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

double outside(Dof dof, double angle) {
  const DofInfo& info = dofInfo(dof);
  return std::max({0.0, angle - info.upper, info.lower - angle});
}

/// The angle between two bones whose ends are `distance` apart, 0 when straight; limited to [0, limit].
double hingeFor(double a, double b, double distance, double limit, double& missing) {
  const double cosine = (distance * distance - a * a - b * b) / (2.0 * a * b);
  double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  angle = std::min(angle, limit);
  const double reached = std::sqrt(std::max(0.0, a * a + b * b + 2.0 * a * b * std::cos(angle)));
  missing = std::abs(distance - reached);
  return angle;
}

/// Orientation of an untwisted left upper arm: from the T-pose (elbow flexing forward and 30 deg up) to a direction in
/// the middle of the range, where the second turn starts.
const dvec3 kMiddleOfReach = glm::normalize(dvec3(0.67, 0.70, -0.25));
dmat3 untwistedMiddle() {
  const dvec3 bone(0.0, 1.0, 0.0), flexing(std::cos(30.0 * kDegree), 0.0, std::sin(30.0 * kDegree));
  const dmat3 R_T(flexing, glm::cross(-bone, flexing), -bone);
  return leastTurn(bone, kMiddleOfReach) * R_T;
}

}  // namespace

LegAngles legInverse(const Figure& figure, Side side, const SegmentPlace& pelvis, const SegmentPlace& foot) {
  const double thigh = figure.thighLength(), shank = figure.shankLength();
  const double out = side == Side::kLeft ? 1.0 : -1.0;
  const dvec3 hip = pelvis.point(figure.p_PS[indexOf(legSegment(side, Segment::kLeftThigh))]);
  const dvec3 h = glm::transpose(foot.R_WS) * (hip - foot.p_WS);
  LegAngles leg;
  leg.knee = hingeFor(thigh, shank, glm::length(h), dofInfo(Dof::kLeftKneeFlexion).upper, leg.missing);
  const double roll = std::atan2(h.y, h.z);
  leg.plantar_flexion = std::atan2(-thigh * std::sin(leg.knee), shank + thigh * std::cos(leg.knee)) -
                        std::atan2(h.x, std::hypot(h.y, h.z));
  leg.inversion = -out * roll;
  const dmat3 R_WShank = foot.R_WS * aboutX(-roll) * aboutY(-leg.plantar_flexion);
  leg.R_PelvisThigh = glm::transpose(pelvis.R_WS) * R_WShank * aboutY(-leg.knee);
  leg.violation = outside(Dof::kLeftAnklePlantarFlexion, leg.plantar_flexion) +
                  outside(Dof::kLeftAnkleInversion, leg.inversion) +
                  ballViolation(BallJoint::kHip, side, leg.R_PelvisThigh);
  return leg;
}

ArmProblem::ArmProblem(const Figure& figure, Side side, const SegmentPlace& thorax, const SegmentPlace& clavicle,
                       const SegmentPlace& hand)
    : side_(side),
      upper_(figure.upperArmLength()),
      forearm_(figure.forearmLength()),
      R_WC_(clavicle.R_WS),
      R_WH_(hand.R_WS),
      R_WThorax_(thorax.R_WS) {
  p_WShoulder_ = clavicle.point(figure.p_PS[indexOf(armSegment(side, Segment::kLeftUpperArm))]);
  const dvec3 reach = hand.p_WS - p_WShoulder_;
  distance_ = glm::length(reach);
  along_ = distance_ > 1e-9 ? reach / distance_ : thorax.R_WS[0];
  elbow_ = hingeFor(upper_, forearm_, distance_, dofInfo(Dof::kLeftElbowFlexion).upper, missing_);
  const double reached = std::sqrt(upper_ * upper_ + forearm_ * forearm_ + 2.0 * upper_ * forearm_ * std::cos(elbow_));
  centre_ = (upper_ * upper_ - forearm_ * forearm_ + reached * reached) / (2.0 * reached);
  radius_ = std::sqrt(std::max(0.0, upper_ * upper_ - centre_ * centre_));
  dvec3 down = -thorax.R_WS[2] - glm::dot(-thorax.R_WS[2], along_) * along_;
  if (glm::length(down) < 1e-6) down = -thorax.R_WS[0] - glm::dot(-thorax.R_WS[0], along_) * along_;
  down_ = glm::normalize(down);
  R_Elbow_ = aboutY(-elbow_);
  outward_ = glm::cross(along_, down_) * (side == Side::kLeft ? 1.0 : -1.0);
}

double ArmProblem::swivelOf(const dvec3& p_WE) const {
  const dvec3 e = p_WE - p_WShoulder_;
  return std::atan2(glm::dot(e, outward_), glm::dot(e, down_));
}

ArmAngles ArmProblem::anglesAt(double swivel) const {
  const double out = side_ == Side::kLeft ? 1.0 : -1.0;
  ArmAngles arm;
  arm.swivel = swivel;
  arm.elbow = elbow_;
  arm.missing = missing_;
  const dvec3 across = std::cos(swivel) * down_ + std::sin(swivel) * outward_;
  const dvec3 bone = (centre_ * along_ + radius_ * across) / upper_;
  // The elbow flexes towards the wrist: away from where the elbow points.
  const double cosine = centre_ / upper_, sine = radius_ / upper_;
  const dvec3 flexing = sine * along_ - cosine * across;
  const dmat3 R_WU(flexing, glm::cross(-bone, flexing), -bone);
  arm.R_ClavicleUpperArm = glm::transpose(R_WC_) * R_WU;
  const dmat3 Q = glm::transpose(R_WU * R_Elbow_) * R_WH_;
  arm.wrist_ulnar = std::asin(std::clamp(-Q[0][2], -1.0, 1.0));
  arm.pronation = -out * std::atan2(Q[0][1], Q[0][0]);
  arm.wrist_flexion = -out * std::atan2(Q[1][2], Q[2][2]);
  return arm;
}

ArmAngles ArmProblem::at(double swivel) const {
  ArmAngles arm = anglesAt(swivel);
  arm.violation = outside(Dof::kLeftPronation, arm.pronation) + outside(Dof::kLeftWristFlexion, arm.wrist_flexion) +
                  outside(Dof::kLeftWristUlnarDeviation, arm.wrist_ulnar) +
                  ballViolation(BallJoint::kShoulder, side_, arm.R_ClavicleUpperArm);
  return arm;
}

double ArmProblem::discomfort(const ArmAngles& arm) const {
  static const dmat3 kUntwisted = untwistedMiddle();
  dmat3 R = glm::transpose(R_WThorax_) * R_WC_ * arm.R_ClavicleUpperArm;
  if (side_ == Side::kRight) R = mirroredRotation(R);
  const dmat3 rest = glm::transpose(leastTurn(kMiddleOfReach, -R[2]) * kUntwisted) * R;
  const double twist = std::atan2(rest[0][1] - rest[1][0], rest[0][0] + rest[1][1]);
  const double bend = std::acos(std::clamp(std::cos(arm.wrist_flexion) * std::cos(arm.wrist_ulnar), -1.0, 1.0));
  const double pronation = arm.pronation - 30.0 * kDegree;
  const double raised = std::remainder(arm.swivel - 80.0 * kDegree, 360.0 * kDegree);
  return 0.33 * pronation * pronation + 0.33 * bend * bend + 0.22 * twist * twist + 0.12 * raised * raised;
}

double ArmProblem::refined(double best, double step) const {
  const double low = discomfort(anglesAt(best - step)), middle = discomfort(anglesAt(best)),
               high = discomfort(anglesAt(best + step));
  const double curvature = low - 2.0 * middle + high;
  if (curvature <= 1e-9) return best;
  return best + std::clamp(0.5 * (low - high) / curvature, -0.5, 0.5) * step;
}

double ArmProblem::preferredSwivel(int samples) const {
  const double step = 360.0 * kDegree / samples;
  double best = 0.0, least = 1e9;
  for (int i = 0; i < samples; ++i) {
    const double swivel = -170.0 * kDegree + i * step;
    const double cost = discomfort(anglesAt(swivel));
    if (cost < least) {
      least = cost;
      best = swivel;
    }
  }
  return refined(best, step);
}

double ArmProblem::preferredSwivelNear(double swivel, double span) const {
  double best = swivel, least = 1e9;
  for (int i = -2; i <= 2; ++i) {
    const double cost = discomfort(anglesAt(swivel + 0.5 * i * span));
    if (cost < least) {
      least = cost;
      best = swivel + 0.5 * i * span;
    }
  }
  return refined(best, 0.5 * span);
}

}  // namespace hapticell::mannequin
