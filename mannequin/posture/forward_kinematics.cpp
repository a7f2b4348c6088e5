// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/forward_kinematics.h"

#include <cmath>
#include <numbers>

#include "mannequin/posture/segment_places.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// R * Ry(a): mixes the columns x and z.
inline dmat3 turnedY(const dmat3& R, double s, double c) {
  return {c * R[0] - s * R[2], R[1], s * R[0] + c * R[2]};
}
inline dmat3 turnedX(const dmat3& R, double s, double c) {
  return {R[0], c * R[1] + s * R[2], c * R[2] - s * R[1]};
}
inline dmat3 turnedZ(const dmat3& R, double s, double c) {
  return {c * R[0] + s * R[1], c * R[1] - s * R[0], R[2]};
}

struct Turner {
  const Figure& figure;
  const SineCosine& sc;
  const BallRotations& balls;
  FigurePose& pose;

  double sine(Dof dof, double sign = 1.0) const { return sign * sc.sine[indexOf(dof)]; }
  double cosine(Dof dof) const { return sc.cosine[indexOf(dof)]; }

  void place(Segment segment, Segment parent, const dmat3& R_WS) const {
    const SegmentPlace& from = pose[parent];
    pose[segment] = {R_WS, from.p_WS + from.R_WS * figure.p_PS[indexOf(segment)]};
  }
  /// A joint of the spine: flexion, right bend, left turn.
  void spine(Segment segment, Segment parent, Dof first) const {
    const auto i = indexOf(first);
    dmat3 R = turnedY(pose[parent].R_WS, sc.sine[i], sc.cosine[i]);
    R = turnedX(R, sc.sine[i + 1], sc.cosine[i + 1]);
    place(segment, parent, turnedZ(R, sc.sine[i + 2], sc.cosine[i + 2]));
  }
  void arm(Side which) const {
    const double side = which == Side::kLeft ? 1.0 : -1.0;
    const auto d = [&](Dof left) { return armDof(which, left); };
    const auto s = [&](Segment left) { return armSegment(which, left); };
    dmat3 R = turnedX(pose[S::kThorax].R_WS, sine(d(Dof::kLeftClavicleElevation), side),
                      cosine(d(Dof::kLeftClavicleElevation)));
    R = turnedZ(R, sine(d(Dof::kLeftClavicleProtraction), -side), cosine(d(Dof::kLeftClavicleProtraction)));
    place(s(S::kLeftClavicle), S::kThorax, R);
    place(s(S::kLeftUpperArm), s(S::kLeftClavicle), R * balls[which == Side::kLeft ? 0 : 1]);
    R = turnedY(pose[s(S::kLeftUpperArm)].R_WS, sine(d(Dof::kLeftElbowFlexion), -1.0),
                cosine(d(Dof::kLeftElbowFlexion)));
    place(s(S::kLeftForearm), s(S::kLeftUpperArm), R);
    R = turnedZ(R, sine(d(Dof::kLeftPronation), -side), cosine(d(Dof::kLeftPronation)));
    place(s(S::kLeftWrist), s(S::kLeftForearm), R);
    R = turnedY(R, sine(d(Dof::kLeftWristUlnarDeviation)), cosine(d(Dof::kLeftWristUlnarDeviation)));
    R = turnedX(R, sine(d(Dof::kLeftWristFlexion), -side), cosine(d(Dof::kLeftWristFlexion)));
    place(s(S::kLeftHand), s(S::kLeftWrist), R);
  }
  void leg(Side which) const {
    const double side = which == Side::kLeft ? 1.0 : -1.0;
    const auto d = [&](Dof left) { return legDof(which, left); };
    const auto s = [&](Segment left) { return legSegment(which, left); };
    place(s(S::kLeftThigh), S::kPelvis, pose[S::kPelvis].R_WS * balls[which == Side::kLeft ? 2 : 3]);
    dmat3 R = turnedY(pose[s(S::kLeftThigh)].R_WS, sine(d(Dof::kLeftKneeFlexion)), cosine(d(Dof::kLeftKneeFlexion)));
    place(s(S::kLeftShank), s(S::kLeftThigh), R);
    R = turnedY(R, sine(d(Dof::kLeftAnklePlantarFlexion)), cosine(d(Dof::kLeftAnklePlantarFlexion)));
    R = turnedX(R, sine(d(Dof::kLeftAnkleInversion), -side), cosine(d(Dof::kLeftAnkleInversion)));
    place(s(S::kLeftFoot), s(S::kLeftShank), R);
    R = turnedY(R, sine(d(Dof::kLeftToesExtension), -1.0), cosine(d(Dof::kLeftToesExtension)));
    place(s(S::kLeftToes), s(S::kLeftFoot), R);
  }
};

/// A ball joint: flexion, abduction, internal rotation; `side` +1 for the left.
dmat3 ballRotation(const SineCosine& sc, Dof first, double side) {
  const auto i = indexOf(first);
  dmat3 R = turnedY(dmat3(1.0), -sc.sine[i], sc.cosine[i]);
  R = turnedX(R, side * sc.sine[i + 1], sc.cosine[i + 1]);
  return turnedZ(R, -side * sc.sine[i + 2], sc.cosine[i + 2]);
}

}  // namespace

void placeSegments(const Figure& figure, const SineCosine& sc, const BallRotations& balls, FigurePose& pose) {
  const Turner turner{figure, sc, balls, pose};
  turner.spine(S::kLowerBack, S::kPelvis, Dof::kVl5Flexion);
  turner.spine(S::kUpperBack, S::kLowerBack, Dof::kVl1Flexion);
  turner.spine(S::kThorax, S::kUpperBack, Dof::kVt6Flexion);
  turner.spine(S::kLowerNeck, S::kThorax, Dof::kVc7Flexion);
  turner.spine(S::kUpperNeck, S::kLowerNeck, Dof::kVc4Flexion);
  turner.spine(S::kHead, S::kUpperNeck, Dof::kSkullbaseFlexion);
  turner.arm(Side::kLeft);
  turner.arm(Side::kRight);
  turner.leg(Side::kLeft);
  turner.leg(Side::kRight);
}

void forwardKinematics(const Figure& figure, const Posture& posture, FigurePose& pose) {
  SineCosine sc;
  sinesAndCosines(posture.angles, sc);
  pose[S::kPelvis] = {glm::mat3_cast(posture.X_WR.q), posture.X_WR.p};
  placeSegments(figure, sc,
                {ballRotation(sc, Dof::kLeftShoulderFlexion, 1.0), ballRotation(sc, Dof::kRightShoulderFlexion, -1.0),
                 ballRotation(sc, Dof::kLeftHipFlexion, 1.0), ballRotation(sc, Dof::kRightHipFlexion, -1.0)},
                pose);
}

FigurePose forwardKinematics(const Figure& figure, const Posture& posture) {
  FigurePose pose;
  forwardKinematics(figure, posture, pose);
  return pose;
}

dmat3 rotationYXZ(const dvec3& angles) {
  dmat3 R(1.0);
  R = turnedY(R, std::sin(angles.y), std::cos(angles.y));
  R = turnedX(R, std::sin(angles.x), std::cos(angles.x));
  return turnedZ(R, std::sin(angles.z), std::cos(angles.z));
}

dvec3 anglesYXZ(const dmat3& R) {
  // Columns first: R[column][row]. R(1,2) = -sin x.
  const double sine = std::fmin(1.0, std::fmax(-1.0, -R[2][1]));
  const double cosine = std::hypot(R[0][1], R[1][1]);
  if (cosine < 1e-9) return {std::copysign(0.5 * std::numbers::pi, sine), std::atan2(-R[0][2], R[0][0]), 0.0};
  const dvec3 near(std::atan2(sine, cosine), std::atan2(R[2][0], R[2][2]), std::atan2(R[0][1], R[1][1]));
  const auto wrapped = [](double a) { return a > 0.0 ? a - std::numbers::pi : a + std::numbers::pi; };
  const dvec3 far((near.x > 0.0 ? std::numbers::pi : -std::numbers::pi) - near.x, wrapped(near.y), wrapped(near.z));
  const auto size = [](const dvec3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); };
  return size(far) < size(near) ? far : near;
}

dvec3 middleOfHips(const FigurePose& pose) {
  return 0.5 * (pose[S::kLeftThigh].p_WS + pose[S::kRightThigh].p_WS);
}

dvec3 centerOfMass(const Figure& figure, const FigurePose& pose, const std::array<HandLoad, 2>& loads) {
  dvec3 moment(0.0);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    moment += figure.mass[i] * pose.segments[i].point(figure.p_SC[i]);
  }
  double mass = figure.totalMass();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const HandLoad& load = loads[static_cast<std::size_t>(side)];
    moment += load.mass * pose[armSegment(side, S::kLeftHand)].point(load.p_HC);
    mass += load.mass;
  }
  return moment / mass;
}

Pose handPose(const FigurePose& pose, Side side) {
  return pose[armSegment(side, S::kLeftHand)].pose();
}

Pose footPose(const FigurePose& pose, Side side) {
  return pose[legSegment(side, S::kLeftFoot)].pose();
}

}  // namespace hapticell::mannequin
