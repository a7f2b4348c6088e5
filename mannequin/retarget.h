// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mannequin/figure.h"
#include "mannequin/motion_clip.h"
#include "mannequin/posture.h"

namespace hapticell::mannequin {

/// A recorded motion on a figure of any size.
struct RetargetedMotion {
  std::vector<Posture> postures;  ///< One a frame.
  double frame_time = 0.0;
  /// Frames in which a limit is exceeded, by what it says of the joint ("l_shoulder, internal rotation"): reported,
  /// nothing is clamped.
  std::map<std::string, int> frames_beyond_limit;
};

/// Which joints of a clip stand for which of the figure's: found by the names of CMU, H-Anim, Biovision and Mixamo.
struct ClipMap {
  int root = -1, thorax = -1, neck = -1, head = -1;
  std::array<int, 3> spine{-1, -1, -1};  ///< Three joints of the spine where the clip has them, from below.
  std::array<int, 2> neck_joints{-1, -1};
  std::array<int, 2> hip{-1, -1}, knee{-1, -1}, ankle{-1, -1};
  std::array<int, 2> shoulder{-1, -1}, elbow{-1, -1}, hand{-1, -1};
};
Expected<ClipMap> mapClip(const MotionClip& clip);

/// World places (Z up, facing X at rest) of what the figure needs from one frame of a clip.
struct ClipBody {
  dmat3 R_root{1.0}, R_thorax{1.0}, R_head{1.0};
  std::array<dmat3, 3> R_spine{};
  std::array<dmat3, 2> R_neck{}, R_hand{}, R_foot{}, R_thigh{}, R_upper_arm{};
  dvec3 p_root{0.0};
  std::array<dvec3, 2> hip{}, knee{}, ankle{}, shoulder{}, elbow{}, hand{};
};
ClipBody bodyOf(const MotionClip& clip, const ClipMap& map, const ClipFrame& frame);

/// Directions are taken over, lengths are the figure's own; the root moves in proportion to the legs, and the whole
/// motion is lowered or raised so that its lowest sole touches the floor. The clip must face its +Z at rest with Y up,
/// arms sideways and palms down, as ASF and the usual BVH do, or hanging with the palms to the thighs, as H-Anim does.
Expected<RetargetedMotion> retarget(const Figure& figure, const MotionClip& clip);

}  // namespace hapticell::mannequin
