// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/figure_measurement.h"

#include <algorithm>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

using mannequin::armDof;
using mannequin::armSegment;
using mannequin::Dof;
using mannequin::Figure;
using mannequin::FigurePose;
using mannequin::legDof;
using mannequin::legSegment;
using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

constexpr double kDegrees = 57.295779513082323;
constexpr double kLiftedFoot = 0.05;   ///< m
constexpr double kKneelingKnee = 0.2;  ///< m

double angleBetween(const dvec3& a, const dvec3& b) {
  return kDegrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Trunk as a frame: up along the spine's line, forward out of the chest, left.
struct TrunkFrame {
  dvec3 up, forward, left;
};

TrunkFrame trunkFrame(const FigurePose& pose) {
  TrunkFrame trunk{};
  trunk.up = glm::normalize(pose[Segment::kLowerNeck].p_WS - middleOfHips(pose));
  const dvec3 chest = pose[Segment::kThorax].R_WS * dvec3(1, 0, 0);
  trunk.left = glm::normalize(glm::cross(trunk.up, chest));
  trunk.forward = glm::cross(trunk.left, trunk.up);
  return trunk;
}

/// What arithmetic leaves of nought is nought: a neck that is 1e-15 deg behind it would be scored as in extension.
double cleaned(double degrees) {
  constexpr double kLeft = 1e-6;
  return std::abs(degrees) < kLeft ? 0.0 : degrees;
}

/// Turn about the vertical, forward bend and side bend of one frame in another, degrees: what its forward axis does,
/// and its left axis.
struct Bends {
  double flexion, side_bend, twist;
};
Bends bendsOf(const dmat3& R) {
  const dvec3 forward = R * dvec3(1, 0, 0);
  const dvec3 left = R * dvec3(0, 1, 0);
  return {cleaned(kDegrees * std::asin(std::clamp(-forward.z, -1.0, 1.0))),
          cleaned(kDegrees * std::asin(std::clamp(left.z, -1.0, 1.0))),
          cleaned(kDegrees * std::atan2(forward.y, forward.x))};
}

dmat3 relative(const FigurePose& pose, Segment base, Segment moved) {
  return glm::transpose(pose[base].R_WS) * pose[moved].R_WS;
}

double degreesOf(const Posture& posture, Dof dof) {
  return kDegrees * posture[dof];
}

void measureTrunk(const FigurePose& pose, MeasuredPosture& measured) {
  const TrunkFrame trunk = trunkFrame(pose);
  const dvec3 ahead = pose[Segment::kPelvis].R_WS * dvec3(1, 0, 0);
  const dvec3 left = glm::cross(dvec3(0, 0, 1), ahead);
  const double leaning = angleBetween(trunk.up, dvec3(0, 0, 1));
  measured.trunk_flexion = glm::dot(trunk.up, ahead) < 0.0 ? -leaning : leaning;
  const double width = glm::length(left);
  measured.trunk_side_bend =
      width > 1e-6 ? kDegrees * std::asin(std::clamp(glm::dot(trunk.up, left / width), -1.0, 1.0)) : 0.0;
  measured.trunk_twist = bendsOf(relative(pose, Segment::kPelvis, Segment::kThorax)).twist;
  const Bends neck = bendsOf(relative(pose, Segment::kThorax, Segment::kHead));
  measured.neck_flexion = neck.flexion;
  measured.neck_side_bend = neck.side_bend;
  measured.neck_twist = neck.twist;
}

void measureArm(const Posture& posture, const FigurePose& pose, Side side, MeasuredPosture& measured) {
  const TrunkFrame trunk = trunkFrame(pose);
  const dvec3 outwards = side == Side::kLeft ? trunk.left : -trunk.left;
  const dvec3 shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
  const dvec3 elbow = pose[armSegment(side, Segment::kLeftForearm)].p_WS;
  const dvec3 wrist = pose[armSegment(side, Segment::kLeftHand)].p_WS;
  const dvec3 upper = glm::normalize(elbow - shoulder);
  const dvec3 fore = glm::normalize(wrist - elbow);
  measured.upper_arm_abduction = kDegrees * std::asin(std::clamp(glm::dot(upper, outwards), -1.0, 1.0));
  const double ahead = glm::dot(upper, trunk.forward);
  const double down = -glm::dot(upper, trunk.up);
  // An arm straight out to the side has no angle in the sagittal plane.
  measured.upper_arm_flexion = std::hypot(ahead, down) > 0.1 ? kDegrees * std::atan2(ahead, down) : 0.0;
  // Straight up is 180, and a little behind that is no extension.
  if (measured.upper_arm_flexion < -120.0) measured.upper_arm_flexion += 360.0;
  measured.upper_arm_rotation = degreesOf(posture, armDof(side, Dof::kLeftShoulderInternalRotation));
  measured.girdle_elevation = degreesOf(posture, armDof(side, Dof::kLeftClavicleElevation));
  measured.lower_arm_flexion = angleBetween(upper, fore);
  const dvec3 chest = pose[Segment::kThorax].p_WS;
  measured.wrist_past_midline = glm::dot(wrist - chest, outwards) < 0.0;
  const double out = glm::dot(fore, outwards), along = glm::dot(fore, trunk.forward);
  measured.lower_arm_outwards = std::hypot(out, along) > 0.3 ? kDegrees * std::atan2(out, along) : 0.0;
  measured.wrist_flexion = degreesOf(posture, armDof(side, Dof::kLeftWristFlexion));
  measured.wrist_deviation = degreesOf(posture, armDof(side, Dof::kLeftWristUlnarDeviation));
  const Dof pronation = armDof(side, Dof::kLeftPronation);
  const double turned = posture[pronation];
  const auto& info = mannequin::dofInfo(pronation);
  measured.wrist_twist_share = turned / (turned < 0.0 ? info.lower : info.upper);
}

/// How much of the weight the heavier foot bears, by where the centre of mass stands between the ankles.
double shareOnHeavierFoot(const Figure& figure, const FigurePose& pose) {
  const dvec3 left = pose[Segment::kLeftFoot].p_WS, right = pose[Segment::kRightFoot].p_WS;
  if (std::abs(left.z - right.z) > kLiftedFoot) return 1.0;
  const dvec3 between = right - left;
  const double square = glm::dot(between, between);
  if (square < 1e-6) return 0.5;
  const double share = glm::dot(mannequin::centerOfMass(figure, pose) - left, between) / square;
  return std::clamp(std::max(share, 1.0 - share), 0.5, 1.0);
}

double kneeFlexion(const Posture& posture, Side side) {
  return std::abs(degreesOf(posture, legDof(side, Dof::kLeftKneeFlexion)));
}

}  // namespace

MeasuredPosture measure(const Figure& figure, const Posture& posture, const FigurePose& pose, Side side) {
  MeasuredPosture measured;
  measureTrunk(pose, measured);
  measureArm(posture, pose, side, measured);
  measured.knee_flexion = std::max(kneeFlexion(posture, Side::kLeft), kneeFlexion(posture, Side::kRight));
  measured.share_on_heavier_foot = shareOnHeavierFoot(figure, pose);
  return measured;
}

OwasPosture owasPosture(const Figure& figure, const Posture& posture, const FigurePose& pose) {
  OwasPosture result;
  MeasuredPosture measured;
  measureTrunk(pose, measured);
  result.trunk_flexion = measured.trunk_flexion;
  result.trunk_twist = measured.trunk_twist;
  result.trunk_side_bend = measured.trunk_side_bend;
  double lowest = std::min(pose[Segment::kLeftToes].p_WS.z, pose[Segment::kRightToes].p_WS.z);
  lowest = std::min({lowest, pose[Segment::kLeftShank].p_WS.z, pose[Segment::kRightShank].p_WS.z});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS.z;
    const double elbow = pose[armSegment(side, Segment::kLeftForearm)].p_WS.z;
    const double wrist = pose[armSegment(side, Segment::kLeftHand)].p_WS.z;
    if (std::max(elbow, wrist) >= shoulder) ++result.arms_at_or_above_shoulder;
    if (pose[legSegment(side, Segment::kLeftShank)].p_WS.z < lowest + kKneelingKnee) result.kneeling = true;
  }
  result.left_knee_flexion = kneeFlexion(posture, Side::kLeft);
  result.right_knee_flexion = kneeFlexion(posture, Side::kRight);
  result.on_one_leg = shareOnHeavierFoot(figure, pose) > PostureThresholds{}.one_leg_share;
  return result;
}

}  // namespace hapticell::ergonomics
