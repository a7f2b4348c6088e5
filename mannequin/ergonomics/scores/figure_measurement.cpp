// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/figure_measurement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mannequin/body/rotations.h"

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
/// m: higher than the thickness of a sole or an uneven floor. Our choice. Half: a foot on a mat is lifted; twice: a
/// foot on a low step bears half the weight.
constexpr double kLiftedFoot = 0.04;
/// m of a knee's joint over the lowest point; a standing shank is twice as long. Our choice. Half: kneeling with a knee
/// on a cushion is missed; twice: a deep squat counts as kneeling.
constexpr double kKneelingKnee = 0.2;

double degreesBetween(const dvec3& a, const dvec3& b) {
  return kDegrees * mannequin::angleBetween(a, b);
}

/// The trunk's planes: up along its line, forward out of the chest, left.
ViewPlanes trunkPlanes(const FigurePose& pose) {
  ViewPlanes trunk;
  trunk.up = glm::normalize(trunkLine(pose));
  const dvec3 chest = pose[Segment::kThorax].R_WS * dvec3(1, 0, 0);
  trunk.outward = glm::normalize(glm::cross(trunk.up, chest));
  trunk.forward = glm::cross(trunk.outward, trunk.up);
  return trunk;
}

/// Of one segment in another, degrees: what the joint's own angles are where there is one joint between them.
struct Bends {
  double flexion, side_bend, twist;
};
Bends bendsOf(const dmat3& R) {
  // A rounding error counts as 0: a neck that is 1e-15 deg behind it would be in extension.
  const auto cleaned = [](double radians) { return std::abs(radians) < 1e-8 ? 0.0 : kDegrees * radians; };
  const dvec3 angles = mannequin::anglesYXZ(R);
  return {cleaned(angles.y), cleaned(angles.x), cleaned(angles.z)};
}

dmat3 relative(const FigurePose& pose, Segment base, Segment moved) {
  return glm::transpose(pose[base].R_WS) * pose[moved].R_WS;
}

double degreesOf(const Posture& posture, Dof dof) {
  return kDegrees * posture[dof];
}

void measureTrunk(const FigurePose& pose, MeasuredPosture& measured) {
  const PlaneAngles trunk = trunkAngles(pelvisPlanes(pose), trunkLine(pose));
  measured.trunk_flexion = trunk.flexion;
  measured.trunk_side_bend = trunk.sideways;
  measured.trunk_twist = bendsOf(relative(pose, Segment::kPelvis, Segment::kThorax)).twist;
  const Bends neck = bendsOf(relative(pose, Segment::kThorax, Segment::kHead));
  measured.neck_flexion = neck.flexion;
  measured.neck_side_bend = neck.side_bend;
  measured.neck_twist = neck.twist;
}

void measureArm(const Posture& posture, const FigurePose& pose, Side side, MeasuredPosture& measured) {
  ViewPlanes trunk = trunkPlanes(pose);
  if (side == Side::kRight) trunk.outward = -trunk.outward;
  const dvec3 shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
  const dvec3 elbow = pose[armSegment(side, Segment::kLeftForearm)].p_WS;
  const dvec3 wrist = pose[armSegment(side, Segment::kLeftHand)].p_WS;
  const PlaneAngles upper = upperArmAngles(trunk, elbow - shoulder);
  measured.upper_arm_flexion = upper.flexion;
  measured.upper_arm_abduction = upper.sideways;
  measured.upper_arm_elevation = upper.elevation;
  measured.upper_arm_rotation = degreesOf(posture, armDof(side, Dof::kLeftShoulderInternalRotation));
  measured.girdle_elevation = degreesOf(posture, armDof(side, Dof::kLeftClavicleElevation));
  measured.lower_arm_flexion = degreesBetween(elbow - shoulder, wrist - elbow);
  const dvec3 chest = pose[Segment::kThorax].p_WS;
  measured.wrist_past_midline = glm::dot(wrist - chest, trunk.outward) < 0.0;
  const double outward = glm::dot(glm::normalize(wrist - elbow), trunk.outward);
  measured.lower_arm_outwards = kDegrees * std::asin(std::clamp(outward, -1.0, 1.0));
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

dvec3 trunkLine(const FigurePose& pose) {
  constexpr std::array<Segment, 5> kSpine{Segment::kPelvis, Segment::kLowerBack, Segment::kUpperBack, Segment::kThorax,
                                          Segment::kLowerNeck};
  dvec3 line(0.0);
  for (std::size_t i = 0; i + 1 < kSpine.size(); ++i) {
    const dvec3& along = pose[kSpine[i]].R_WS[2];
    const dvec3 from = i == 0 ? middleOfHips(pose) : pose[kSpine[i]].p_WS;
    line += glm::dot(pose[kSpine[i + 1]].p_WS - from, along) * along;
  }
  return line;
}

ViewPlanes pelvisPlanes(const FigurePose& pose) {
  const dmat3& R = pose[Segment::kPelvis].R_WS;
  ViewPlanes planes;
  const dvec3 level_left(R[1].x, R[1].y, 0.0);
  // On its side it has no level left: then what is ahead of it.
  planes.outward = glm::length(level_left) > 1e-3
                       ? glm::normalize(level_left)
                       : glm::normalize(glm::cross(dvec3(0, 0, 1), R[0]) + dvec3(0, 1e-9, 0));
  planes.forward = glm::cross(planes.outward, planes.up);
  return planes;
}

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
