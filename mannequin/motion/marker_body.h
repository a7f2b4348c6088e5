// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/motion/marker_set.h"
#include "mannequin/motion/recorded_motion.h"

namespace hapticell::mannequin {

/// The person in a recording of markers. Hips by Harrington and others (J. Biomechanics 40, 2007) from the pelvis's
/// markers; knees, ankles and elbows between both sides' markers, or beside the one by half a joint's breadth;
/// shoulders below the acromion; segments' frames as Plug-in Gait lays them. Offsets are our choice
/// (docs/dev/mannequin.md). Markers that are not seen for a while (or stand at 0 0 0) are taken on the straight way
/// between; which, and for how long, is said. Errors: a landmark that is needed and never seen, frames in which a limb
/// has no length.
Expected<RecordedMotion> recordedMotion(const MarkerClip& clip, const MarkerSet& set);

}  // namespace hapticell::mannequin
