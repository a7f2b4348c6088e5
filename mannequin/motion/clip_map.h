// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mannequin/motion/motion_clip.h"

namespace hapticell::mannequin {

/// Maps joints of a clip to those of the figure; -1: no joint. Arrays: left, right.
struct ClipMap {
  int root = -1;    ///< The pelvis: the common parent of both legs and the spine.
  int thorax = -1;  ///< The common parent of both arms and the head; the pelvis if there is no spine.
  int neck = -1;    ///< The lowest joint between thorax and head.
  int head = -1;
  std::array<int, 3> spine{-1, -1, -1};  ///< From below, the last is the thorax; the others if the clip has them.
  std::array<int, 2> neck_joints{-1, -1};
  std::array<int, 2> hip{-1, -1}, knee{-1, -1}, ankle{-1, -1}, toe{-1, -1};
  std::array<int, 2> collar{-1, -1}, shoulder{-1, -1}, elbow{-1, -1}, hand{-1, -1};
  /// Of each hand: a joint along the fingers, the root of the thumb, and the knuckles of index and little finger.
  std::array<int, 2> fingers{-1, -1}, thumb{-1, -1}, index{-1, -1}, little{-1, -1};
  int head_end = -1;  ///< The top of the head.
};

/// Finds limbs and head by their names (those of CMU, H-Anim, Biovision, Mixamo, Rokoko, Motive, LAFAN1, Unreal, Biped,
/// Xsens and SMPL are known, with any namespace), the rest by the hierarchy. Error: what is missing, with the names in
/// the file. Neck, collars, toes, fingers and parts of the spine may be missing.
Expected<ClipMap> mapJoints(const MotionClip& clip);

}  // namespace hapticell::mannequin
