// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/body_frames.h"

namespace hapticell::mannequin {

BodyFrames::BodyFrames(const MotionClip& clip, const ClipMap& map, const dmat3& R_WC)
    : map_(map), R_WC_(R_WC), frames_(BodyFrameFinder(clip, map_, R_WC).find()) {}

dvec3 BodyFrames::place(const ClipPose& pose, int joint) const {
  return R_WC_ * pose.p[static_cast<std::size_t>(joint)];
}
dmat3 BodyFrames::turned(const ClipPose& pose, int joint, const dmat3& B) const {
  return R_WC_ * glm::mat3_cast(pose.q[static_cast<std::size_t>(joint)]) * B;
}

RecordedBody BodyFrames::bodyAt(const ClipPose& pose) const {
  RecordedBody body;
  body.R_root = turned(pose, map_.root, frames_.root);
  body.R_thorax = body.R_spine[2] = turned(pose, map_.thorax, frames_.thorax);
  body.R_head = turned(pose, map_.head, frames_.head);
  body.R_spine[0] = map_.spine[0] >= 0 ? turned(pose, map_.spine[0], frames_.spine[0]) : body.R_root;
  body.R_spine[1] = map_.spine[1] >= 0 ? turned(pose, map_.spine[1], frames_.spine[1]) : body.R_spine[0];
  body.R_neck[0] = map_.neck_joints[0] >= 0 ? turned(pose, map_.neck_joints[0], frames_.neck[0]) : body.R_thorax;
  body.R_neck[1] = map_.neck_joints[1] >= 0 ? turned(pose, map_.neck_joints[1], frames_.neck[1]) : body.R_neck[0];
  body.neck = R_WC_ * neckBase(map_, pose);
  for (std::size_t i = 0; i < 2; ++i) {
    body.hip[i] = place(pose, map_.hip[i]);
    body.knee[i] = place(pose, map_.knee[i]);
    body.ankle[i] = place(pose, map_.ankle[i]);
    body.shoulder[i] = place(pose, map_.shoulder[i]);
    body.elbow[i] = place(pose, map_.elbow[i]);
    body.hand[i] = place(pose, map_.hand[i]);
    body.R_hand[i] = turned(pose, map_.hand[i], frames_.hand[i]);
    body.R_foot[i] = turned(pose, map_.ankle[i], frames_.foot[i]);
    body.thigh_forward[i] = turned(pose, map_.hip[i], dmat3(1.0)) * frames_.thigh_forward[i];
    body.arm_forward[i] = turned(pose, map_.shoulder[i], dmat3(1.0)) * frames_.arm_forward[i];
  }
  body.p_root = 0.5 * (body.hip[0] + body.hip[1]);
  return body;
}

}  // namespace hapticell::mannequin
