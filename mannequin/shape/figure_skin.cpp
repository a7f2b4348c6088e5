// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/figure_skin.h"

#include <cmath>

#include "mannequin/shape/face_shape.h"
#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// A rigid motion as a unit dual quaternion: turn, and half of shift times turn.
struct DualMotion {
  glm::vec4 turn{0.0f}, shift{0.0f};  // (x, y, z, w)
};

DualMotion motionBetween(const SegmentPlace& from, const SegmentPlace& to) {
  const dmat3 R = to.R_WS * glm::transpose(from.R_WS);
  const dvec3 p = to.p_WS - R * from.p_WS;
  const glm::dquat q = glm::normalize(glm::quat_cast(R));
  const glm::dquat d = 0.5 * (glm::dquat(0.0, p.x, p.y, p.z) * q);
  return {glm::vec4(glm::dvec4(q.x, q.y, q.z, q.w)), glm::vec4(glm::dvec4(d.x, d.y, d.z, d.w))};
}

fvec3 turned(const glm::vec4& turn, const fvec3& p) {
  const fvec3 q(turn);
  return p + 2.0f * glm::cross(q, glm::cross(q, p) + turn.w * p);
}

fvec3 moved(const glm::vec4& turn, const glm::vec4& shift, const fvec3& p) {
  const fvec3 q(turn), d(shift);
  return turned(turn, p) + 2.0f * (turn.w * d - shift.w * q + glm::cross(q, d));
}

}  // namespace

std::vector<SegmentPlace> skinBonePlaces(const Figure& figure, const FigurePose& pose, const Posture& posture) {
  std::vector<SegmentPlace> bones(pose.segments.begin(), pose.segments.end());
  bones.resize(kSkinBones);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto fingers = phalanxPlaces(figure, posture, side, pose[armSegment(side, S::kLeftHand)]);
    for (std::size_t d = 0; d < kDigits; ++d)
      for (std::size_t i = 0; i < kPhalanges; ++i) bones[phalanxBody(side, d, i)] = fingers[d][i];
    const SegmentPlace& head = pose[S::kHead];
    bones[kEyeBones + static_cast<std::size_t>(side)] = {head.R_WS * eyeRotation(posture.gaze),
                                                         head.point(eyeCentre(figure, side))};
    const SegmentPlace &girdle = pose[armSegment(side, S::kLeftClavicle)],
                       &arm = pose[armSegment(side, S::kLeftUpperArm)];
    // The least turn from where the arm points in the bind posture.
    const dmat3 R_CBind = ballRotationOf(bindPosture(), armDof(side, Dof::kLeftShoulderFlexion));
    const dvec3 points = -(glm::transpose(girdle.R_WS) * arm.R_WS[2]);
    bones[kSwungArms + static_cast<std::size_t>(side)] = {girdle.R_WS * leastTurn(-R_CBind[2], points) * R_CBind,
                                                          arm.p_WS};
  }
  return bones;
}

void FigureSkin::pose(const Posture& posture, std::vector<fvec3>& places, std::vector<fvec3>& normals) const {
  const std::vector<SegmentPlace> bones = skinBonePlaces(*figure_, forwardKinematics(*figure_, posture), posture);
  std::array<DualMotion, kSkinBones> motions;
  for (std::size_t i = 0; i < kSkinBones; ++i) motions[i] = motionBetween(bind_[i], bones[i]);
  places.resize(vertices_.size());
  normals.resize(vertices_.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Vertex& vertex = vertices_[v];
    const SkinWeights& weights = vertex.weights;
    const glm::vec4 first = motions[weights.bone[0]].turn;
    glm::vec4 turn(0.0f), shift(0.0f);
    for (std::size_t i = 0; i < SkinWeights::kMost && weights.share[i] > 0.0f; ++i) {
      const DualMotion& motion = motions[weights.bone[i]];
      // q and -q are the same turn; blended are those on one side.
      const float share = glm::dot(first, motion.turn) < 0.0f ? -weights.share[i] : weights.share[i];
      turn += share * motion.turn;
      shift += share * motion.shift;
    }
    const float scale = 1.0f / glm::length(turn);
    turn *= scale;
    shift *= scale;
    places[v] = moved(turn, shift, vertex.place);
    normals[v] = turned(turn, vertex.normal);
    if (vertex.straight <= 0.0f) continue;
    fvec3 straight(0.0f);
    for (std::size_t i = 0; i < SkinWeights::kMost && weights.share[i] > 0.0f; ++i) {
      const DualMotion& motion = motions[weights.bone[i]];
      straight += weights.share[i] * moved(motion.turn, motion.shift, vertex.place);
    }
    places[v] += vertex.straight * (straight - places[v]);
  }
}

}  // namespace hapticell::mannequin
