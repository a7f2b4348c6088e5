// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mannequin/body/figure.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/posture/posture.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::mannequin {

/// A recorded motion on a figure of any size.
struct RetargetedMotion {
  std::vector<Posture> postures;  ///< One a frame.
  double frame_time = 0.0;
  /// Frames in which a limit is exceeded, by LimitViolation::what ("l_shoulder, internal rotation,"): reported,
  /// nothing is clamped.
  std::map<std::string, int> frames_beyond_limit;
};

/// Directions are taken over, lengths are the figure's own; the root moves in proportion to the legs, and the whole
/// motion is lowered or raised so that its lowest sole touches the floor. Errors: legs without length.
Expected<RetargetedMotion> retarget(const Figure& figure, const RecordedMotion& motion);
/// The same of a clip, with recordedMotion()'s errors.
Expected<RetargetedMotion> retarget(const Figure& figure, const MotionClip& clip);

}  // namespace hapticell::mannequin
