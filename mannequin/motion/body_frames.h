// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "mannequin/motion/clip_map.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::mannequin {

/// Orientation of the frames of a clip's joints relative to the segments that they carry. Programs choose these frames
/// differently (parallel at a T-pose, each along its bone, with the hips turned). What the joints' positions determine
/// is computed from them. The rest (where the head looks, how a hand is turned about the forearm) comes from the rest
/// position if that agrees with the motion. Else it comes from the nearest axis of the joint's frame on average, else
/// from the mean.
class BodyFrames {
 public:
  /// `R_WC` turns the clip's axes into the world (Z up). The clip is used during construction only.
  BodyFrames(const MotionClip& clip, const ClipMap& map, const dmat3& R_WC);

  /// One frame, from the positions of the clip's joints.
  RecordedBody bodyAt(const ClipPose& pose) const;
  /// Assumptions, one sentence each.
  const std::vector<Text>& assumptions() const { return assumptions_; }

 private:
  class Finder;
  dvec3 place(const ClipPose& pose, int joint) const;
  dmat3 turned(const ClipPose& pose, int joint, const dmat3& B) const;

  ClipMap map_;
  dmat3 R_WC_;
  /// The segment's frame in the joint's.
  dmat3 root_{1.0}, thorax_{1.0}, head_{1.0};
  std::array<dmat3, 2> spine_{dmat3(1.0), dmat3(1.0)}, neck_{dmat3(1.0), dmat3(1.0)}, hand_{dmat3(1.0), dmat3(1.0)},
      foot_{dmat3(1.0), dmat3(1.0)};
  std::array<dvec3, 2> thigh_forward_{}, arm_forward_{};
  std::vector<Text> assumptions_;
};

/// The base of the neck at one frame: the lowest neck joint, else midway between the collars, else between the
/// shoulders.
dvec3 neckBase(const ClipMap& map, const ClipPose& pose);

/// The clip's body frame at rest (all rotations zero) by columns forward, left, up, in the file's axes; empty if the
/// bones are not placed as those of a standing person.
std::optional<dmat3> restFrame(const MotionClip& clip, const ClipMap& map);

}  // namespace hapticell::mannequin
