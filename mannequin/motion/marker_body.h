// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/motion/marker_set.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::mannequin {

/// The person in a recording of markers. Hips by Harrington and others (J. Biomechanics 40, 2007) from the markers of
/// the pelvis; knees, ankles and elbows between the markers of both sides, or half a joint's breadth beside the only
/// one; shoulders below the acromion; frames of segments as in Plug-in Gait. Offsets are our choice
/// (docs/dev/mannequin.md). Markers that are not visible for a while (or are at 0 0 0) are interpolated on a straight
/// line; which ones, and for how long, is reported. Errors: a required landmark that is never visible, frames in which
/// a limb has no length.
Expected<RecordedMotion> recordedMotion(const MarkerClip& clip, const MarkerSet& set);

}  // namespace hapticell::mannequin
