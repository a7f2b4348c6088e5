// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/text.h"
#include "mannequin/motion/body_frame_finder.h"
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
  const std::vector<Text>& assumptions() const { return frames_.assumptions; }

 private:
  dvec3 place(const ClipPose& pose, int joint) const;
  dmat3 turned(const ClipPose& pose, int joint, const dmat3& B) const;

  ClipMap map_;
  dmat3 R_WC_;
  SegmentFrames frames_;
};

}  // namespace hapticell::mannequin
