// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mannequin/body/figure.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/recorded_motion.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// A recorded motion on a figure of any size.
struct RetargetedMotion {
  std::vector<Posture> postures;  ///< One a frame.
  double frame_time = 0.0;
  /// Frames in which a limit is exceeded, by LimitViolation::what ("l_shoulder, internal rotation,"): reported,
  /// nothing is clamped.
  std::map<std::string, int> frames_beyond_limit;
};

/// Directions are kept, lengths are those of the figure; the root moves in proportion to the legs, and the whole motion
/// is lowered or raised so that its lowest sole touches the floor. Errors: legs without length.
Expected<RetargetedMotion> retarget(const Figure& figure, const RecordedMotion& motion);
/// The same for a clip, with the errors of recordedMotion().
Expected<RetargetedMotion> retarget(const Figure& figure, const MotionClip& clip);

}  // namespace hapticell::mannequin
