// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/retarget.h"

#include <algorithm>
#include <cmath>

#include "mannequin/body/rotations.h"
#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// A limb's upper bone: -z along it, and x such that the next bone bends in the x-z plane; `forward` tells the side
/// where the bone is nearly straight.
dmat3 hingeFrame(const dvec3& from, const dvec3& middle, const dvec3& to, double bends, const dvec3& forward) {
  const dvec3 bone = glm::normalize(middle - from), next = glm::normalize(to - middle);
  dvec3 x = bends * (next - glm::dot(next, bone) * bone);
  if (glm::length(x) < 0.12) x = forward - glm::dot(forward, bone) * bone;
  x = glm::normalize(x);
  return {x, glm::cross(-bone, x), -bone};
}

/// Sets the three angles of a spine joint from its segment's turn in its parent.
void setSpine(Posture& posture, Dof first, const dmat3& R_parent, const dmat3& R) {
  const dvec3 angles = anglesYXZ(glm::transpose(R_parent) * R);
  const std::size_t i = indexOf(first);
  posture.angles[i] = angles.y;
  posture.angles[i + 1] = angles.x;
  posture.angles[i + 2] = angles.z;
}

void setArmOf(const RecordedBody& body, Side side, Posture& posture) {
  const std::size_t i = static_cast<std::size_t>(side);
  const double out = outwardSign(side);
  const dmat3 R_upper = hingeFrame(body.shoulder[i], body.elbow[i], body.hand[i], 1.0, body.arm_forward[i]);
  setBallRotation(posture, armDof(side, Dof::kLeftShoulderFlexion), glm::transpose(body.R_thorax) * R_upper);
  const double flexion = angleBetween(body.elbow[i] - body.shoulder[i], body.hand[i] - body.elbow[i]);
  posture[armDof(side, Dof::kLeftElbowFlexion)] = flexion;
  const dmat3 Q = glm::transpose(R_upper * aboutY(-flexion)) * body.R_hand[i];
  posture[armDof(side, Dof::kLeftPronation)] = -out * std::atan2(Q[0][1], Q[0][0]);
  posture[armDof(side, Dof::kLeftWristUlnarDeviation)] = std::asin(std::clamp(-Q[0][2], -1.0, 1.0));
  posture[armDof(side, Dof::kLeftWristFlexion)] = -out * std::atan2(Q[1][2], Q[2][2]);
}

void setLegOf(const RecordedBody& body, Side side, Posture& posture) {
  const std::size_t i = static_cast<std::size_t>(side);
  const dmat3 R_thigh = hingeFrame(body.hip[i], body.knee[i], body.ankle[i], -1.0, body.thigh_forward[i]);
  setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), glm::transpose(body.R_root) * R_thigh);
  const double flexion = angleBetween(body.knee[i] - body.hip[i], body.ankle[i] - body.knee[i]);
  posture[legDof(side, Dof::kLeftKneeFlexion)] = flexion;
  const dvec3 ankle = anglesYXZ(glm::transpose(R_thigh * aboutY(flexion)) * body.R_foot[i]);
  posture[legDof(side, Dof::kLeftAnklePlantarFlexion)] = ankle.y;
  posture[legDof(side, Dof::kLeftAnkleInversion)] = -outwardSign(side) * ankle.x;
}

Posture postureOf(const RecordedBody& body, double scale) {
  Posture posture;
  posture.X_WR = {scale * body.p_root, glm::normalize(glm::quat_cast(body.R_root))};
  dmat3 parent = body.R_root;
  constexpr std::array<Dof, 3> kSpine = {Dof::kVl5Flexion, Dof::kVl1Flexion, Dof::kVt6Flexion};
  for (std::size_t k = 0; k < 3; ++k) {
    setSpine(posture, kSpine[k], parent, body.R_spine[k]);
    parent = body.R_spine[k];
  }
  setSpine(posture, Dof::kVc7Flexion, body.R_thorax, body.R_neck[0]);
  setSpine(posture, Dof::kVc4Flexion, body.R_neck[0], body.R_neck[1]);
  setSpine(posture, Dof::kSkullbaseFlexion, body.R_neck[1], body.R_head);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    setArmOf(body, side, posture);
    setLegOf(body, side, posture);
  }
  return posture;
}

double lowestSole(const Figure& figure, const Posture& posture) {
  const FigurePose pose = forwardKinematics(figure, posture);
  double lowest = 1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SegmentPlace& foot = pose[legSegment(side, S::kLeftFoot)];
    for (const double x : {figure.sole.heel_x, figure.sole.ball_x}) {
      lowest = std::min(lowest, foot.point({x, 0.0, figure.sole.z}).z);
    }
  }
  return lowest;
}

}  // namespace

Expected<RetargetedMotion> retarget(const Figure& figure, const RecordedMotion& recorded) {
  RetargetedMotion motion;
  motion.frame_time = recorded.frame_time;
  if (recorded.bodies.empty()) return motion;
  const RecordedBody& first = recorded.bodies.front();
  const double leg = glm::length(first.knee[0] - first.hip[0]) + glm::length(first.ankle[0] - first.knee[0]);
  if (!(leg > 1e-3)) return makeError({.found = "legs of length zero", .expected = "a skeleton"});
  const double scale = (figure.thighLength() + figure.shankLength()) / leg;
  double lowest = 1e9;
  motion.postures.reserve(recorded.bodies.size());
  for (const RecordedBody& body : recorded.bodies) {
    motion.postures.push_back(postureOf(body, scale));
    lowest = std::min(lowest, lowestSole(figure, motion.postures.back()));
  }
  for (Posture& posture : motion.postures) {
    posture.X_WR.p.z -= lowest;
    for (const LimitViolation& beyond : limitViolations(posture, 0.1 * kDegree)) {
      ++motion.frames_beyond_limit[beyond.what];
    }
  }
  return motion;
}

Expected<RetargetedMotion> retarget(const Figure& figure, const MotionClip& clip) {
  const Expected<RecordedMotion> recorded = recordedMotion(clip);
  HAPTICELL_TRY(recorded);
  return retarget(figure, *recorded);
}

}  // namespace hapticell::mannequin
