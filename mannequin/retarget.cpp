// SPDX-License-Identifier: Apache-2.0
#include "mannequin/retarget.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "mannequin/forward_kinematics.h"
#include "mannequin/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

constexpr double kHanging = 0.87;  ///< Of an upper arm at rest that points down: within 30 deg.

/// The clip's axes (Y up, facing Z) in the world's (Z up, facing X).
const dmat3 kTurn(dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 0, 0));

dvec3 inWorld(const dvec3& v) {
  return kTurn * v;
}
dmat3 inWorld(const dquat& q) {
  return kTurn * glm::mat3_cast(q) * glm::transpose(kTurn);
}

int findAny(const MotionClip& clip, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const int found = clip.find(name); found >= 0) return found;
  }
  return -1;
}

/// A limb's upper bone: -z along it, and x such that the next bone bends in the x-z plane; `forward` tells the side
/// where the bone is nearly straight.
dmat3 hingeFrame(const dvec3& from, const dvec3& middle, const dvec3& to, double bends, const dvec3& forward) {
  const dvec3 bone = glm::normalize(middle - from), next = glm::normalize(to - middle);
  dvec3 x = bends * (next - glm::dot(next, bone) * bone);
  if (glm::length(x) < 0.12) x = forward - glm::dot(forward, bone) * bone;
  x = glm::normalize(x);
  return {x, glm::cross(-bone, x), -bone};
}

double angleBetween(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Sets the three angles of a spine joint from its segment's turn in its parent.
void setSpine(Posture& posture, Dof first, const dmat3& R_parent, const dmat3& R) {
  const dvec3 angles = anglesYXZ(glm::transpose(R_parent) * R);
  const std::size_t i = indexOf(first);
  posture.angles[i] = angles.y;
  posture.angles[i + 1] = angles.x;
  posture.angles[i + 2] = angles.z;
}

void setArmOf(const ClipBody& body, Side side, Posture& posture) {
  const std::size_t i = static_cast<std::size_t>(side);
  const double out = outwardSign(side);
  const dmat3 R_upper =
      hingeFrame(body.shoulder[i], body.elbow[i], body.hand[i], 1.0, body.R_upper_arm[i] * dvec3(1, 0, 0));
  setBallRotation(posture, armDof(side, Dof::kLeftShoulderFlexion), glm::transpose(body.R_thorax) * R_upper);
  const double flexion = angleBetween(body.elbow[i] - body.shoulder[i], body.hand[i] - body.elbow[i]);
  posture[armDof(side, Dof::kLeftElbowFlexion)] = flexion;
  const dmat3 Q = glm::transpose(R_upper * aboutY(-flexion)) * body.R_hand[i];
  posture[armDof(side, Dof::kLeftPronation)] = -out * std::atan2(Q[0][1], Q[0][0]);
  posture[armDof(side, Dof::kLeftWristUlnarDeviation)] = std::asin(std::clamp(-Q[0][2], -1.0, 1.0));
  posture[armDof(side, Dof::kLeftWristFlexion)] = -out * std::atan2(Q[1][2], Q[2][2]);
}

void setLegOf(const ClipBody& body, Side side, Posture& posture) {
  const std::size_t i = static_cast<std::size_t>(side);
  const dmat3 R_thigh = hingeFrame(body.hip[i], body.knee[i], body.ankle[i], -1.0, body.R_thigh[i] * dvec3(1, 0, 0));
  setBallRotation(posture, legDof(side, Dof::kLeftHipFlexion), glm::transpose(body.R_root) * R_thigh);
  const double flexion = angleBetween(body.knee[i] - body.hip[i], body.ankle[i] - body.knee[i]);
  posture[legDof(side, Dof::kLeftKneeFlexion)] = flexion;
  const dvec3 ankle = anglesYXZ(glm::transpose(R_thigh * aboutY(flexion)) * body.R_foot[i]);
  posture[legDof(side, Dof::kLeftAnklePlantarFlexion)] = ankle.y;
  posture[legDof(side, Dof::kLeftAnkleInversion)] = -outwardSign(side) * ankle.x;
}

Posture postureOf(const ClipBody& body, double scale) {
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

std::string withoutNumbers(const std::string& sentence) {
  return sentence.substr(0, sentence.find(" is "));
}

}  // namespace

Expected<ClipMap> mapClip(const MotionClip& clip) {
  ClipMap map;
  map.root = findAny(clip, {"root", "humanoid_root", "hips", "pelvis", "mixamorig:hips"});
  map.spine = {findAny(clip, {"lowerback", "vl5", "spine", "mixamorig:spine", "lowerspine"}),
               findAny(clip, {"upperback", "vl1", "spine1", "mixamorig:spine1"}),
               findAny(clip, {"thorax", "vt6", "chest", "spine2", "mixamorig:spine2", "upperchest"})};
  map.thorax = map.spine[2];
  for (const int joint : {map.spine[1], map.spine[0]}) map.thorax = map.thorax < 0 ? joint : map.thorax;
  map.neck_joints = {findAny(clip, {"lowerneck", "vc7", "neck", "mixamorig:neck"}),
                     findAny(clip, {"upperneck", "vc4", "neck1"})};
  map.neck = map.neck_joints[0];
  map.head = findAny(clip, {"head", "skullbase", "mixamorig:head"});
  map.hip = {findAny(clip, {"lfemur", "l_hip", "leftupleg", "lefthip", "mixamorig:leftupleg", "lthigh"}),
             findAny(clip, {"rfemur", "r_hip", "rightupleg", "righthip", "mixamorig:rightupleg", "rthigh"})};
  map.knee = {findAny(clip, {"ltibia", "l_knee", "leftleg", "leftknee", "mixamorig:leftleg", "lshin"}),
              findAny(clip, {"rtibia", "r_knee", "rightleg", "rightknee", "mixamorig:rightleg", "rshin"})};
  map.ankle = {findAny(clip, {"lfoot", "l_talocrural", "l_ankle", "leftfoot", "leftankle", "mixamorig:leftfoot"}),
               findAny(clip, {"rfoot", "r_talocrural", "r_ankle", "rightfoot", "rightankle", "mixamorig:rightfoot"})};
  map.shoulder = {findAny(clip, {"lhumerus", "l_shoulder", "leftarm", "leftshoulder", "mixamorig:leftarm"}),
                  findAny(clip, {"rhumerus", "r_shoulder", "rightarm", "rightshoulder", "mixamorig:rightarm"})};
  map.elbow = {findAny(clip, {"lradius", "l_elbow", "leftforearm", "leftelbow", "mixamorig:leftforearm"}),
               findAny(clip, {"rradius", "r_elbow", "rightforearm", "rightelbow", "mixamorig:rightforearm"})};
  map.hand = {findAny(clip, {"lhand", "l_wrist", "lefthand", "leftwrist", "mixamorig:lefthand"}),
              findAny(clip, {"rhand", "r_wrist", "righthand", "rightwrist", "mixamorig:righthand"})};
  const std::pair<const char*, int> needed[] = {{"hips", map.root},
                                                {"chest", map.thorax},
                                                {"head", map.head},
                                                {"left hip", map.hip[0]},
                                                {"right hip", map.hip[1]},
                                                {"left knee", map.knee[0]},
                                                {"right knee", map.knee[1]},
                                                {"left ankle", map.ankle[0]},
                                                {"right ankle", map.ankle[1]},
                                                {"left shoulder", map.shoulder[0]},
                                                {"right shoulder", map.shoulder[1]},
                                                {"left elbow", map.elbow[0]},
                                                {"right elbow", map.elbow[1]},
                                                {"left wrist", map.hand[0]},
                                                {"right wrist", map.hand[1]}};
  for (const auto& [what, joint] : needed) {
    if (joint < 0)
      return makeError({"", "", std::string("a skeleton without a joint for the ") + what,
                        "joints named as CMU, H-Anim, Biovision or Mixamo do", ""});
  }
  return map;
}

ClipBody bodyOf(const MotionClip& clip, const ClipMap& map, const ClipFrame& frame) {
  thread_local ClipPose pose;
  placeJoints(clip, frame, pose);
  const auto q = [&](int joint) { return inWorld(pose.q[static_cast<std::size_t>(joint)]); };
  const auto p = [&](int joint) { return inWorld(pose.p[static_cast<std::size_t>(joint)]); };
  ClipBody body;
  body.R_root = q(map.root);
  body.p_root = 0.5 * (p(map.hip[0]) + p(map.hip[1]));
  for (std::size_t k = 0; k < 3; ++k) {
    const int joint = map.spine[k] >= 0 ? map.spine[k] : k == 2 ? map.thorax : -1;
    body.R_spine[k] = joint >= 0 ? q(joint) : k == 0 ? body.R_root : body.R_spine[k - 1];
  }
  body.R_thorax = body.R_spine[2];
  body.R_neck[0] = map.neck_joints[0] >= 0 ? q(map.neck_joints[0]) : body.R_thorax;
  body.R_neck[1] = map.neck_joints[1] >= 0 ? q(map.neck_joints[1]) : body.R_neck[0];
  body.R_head = q(map.head);
  for (std::size_t i = 0; i < 2; ++i) {
    const double out = i == 0 ? 1.0 : -1.0;
    body.hip[i] = p(map.hip[i]);
    body.knee[i] = p(map.knee[i]);
    body.ankle[i] = p(map.ankle[i]);
    body.shoulder[i] = p(map.shoulder[i]);
    body.elbow[i] = p(map.elbow[i]);
    body.hand[i] = p(map.hand[i]);
    body.R_thigh[i] = q(map.hip[i]);
    body.R_foot[i] = q(map.ankle[i]);
    body.R_upper_arm[i] = q(map.shoulder[i]);
    // At rest the hand points sideways with the palm down, or hangs with it to the thigh.
    const dvec3 upper_arm = inWorld(clip.joints[static_cast<std::size_t>(map.elbow[i])].p_Parent);
    const bool hangs = upper_arm.z < -kHanging * glm::length(upper_arm);
    body.R_hand[i] = q(map.hand[i]) * (hangs ? dmat3(1.0) : aboutX(out * 0.5 * M_PI));
  }
  return body;
}

Expected<RetargetedMotion> retarget(const Figure& figure, const MotionClip& clip) {
  const Expected<ClipMap> map = mapClip(clip);
  if (!map) return makeError(map.error());
  const auto length = [&](int joint) { return glm::length(clip.joints[static_cast<std::size_t>(joint)].p_Parent); };
  const double leg = length(map->knee[0]) + length(map->ankle[0]);
  if (!(leg > 1e-3)) return makeError({"", "", "legs without length", "a skeleton", ""});
  const double scale = (figure.thighLength() + figure.shankLength()) / leg;
  RetargetedMotion motion;
  motion.frame_time = clip.frame_time;
  double lowest = 1e9;
  for (const ClipFrame& frame : clip.frames) {
    motion.postures.push_back(postureOf(bodyOf(clip, *map, frame), scale));
    lowest = std::min(lowest, lowestSole(figure, motion.postures.back()));
  }
  for (Posture& posture : motion.postures) {
    posture.X_WR.p.z -= lowest;
    for (const std::string& sentence : limitViolations(posture, 0.1 * kDegree)) {
      ++motion.frames_beyond_limit[withoutNumbers(sentence)];
    }
  }
  return motion;
}

}  // namespace hapticell::mannequin
