// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::ergonomics {

/// The planes in which a limb or the trunk is looked at. Unit vectors, square to each other, in any one frame.
struct ViewPlanes {
  dvec3 forward{1, 0, 0};
  dvec3 outward{0, 1, 0};  ///< Of the trunk to its left; of an arm away from the trunk.
  dvec3 up{0, 0, 1};
};

/// A line of the body against where it counts as 0, degrees.
struct PlaneAngles {
  double flexion = 0.0;    ///< Seen from the side, forward positive.
  double sideways = 0.0;   ///< Out of the sagittal plane, outward positive; -90 to 90.
  double elevation = 0.0;  ///< The whole angle, whichever way; 0 to 180.
};

/// The trunk from hips to neck, `line` of any length but 0: flexion from upright, -180 to 180. A line that goes
/// straight to a side has none: nearer than 11.5 deg to there flexion fades to 0, as nothing can be seen from the side.
PlaneAngles trunkAngles(const ViewPlanes& planes, const dvec3& line);

/// The upper arm from shoulder to elbow: flexion from hanging along the trunk; behind it negative. What is seen from
/// the side up to 78.7 deg outward; farther out the side view is short and flexion fades to 0 at straight out to the
/// side. An arm above the shoulder's level counts by its elevation, whichever way it was raised: from level on, over 15
/// deg, flexion goes over to that. So it is continuous in all directions, 180 for straight up.
PlaneAngles upperArmAngles(const ViewPlanes& planes, const dvec3& line);

/// Elevation of an arm of which flexion and sideways angle are known, degrees: the inverse for arms below level.
double armElevation(double flexion, double sideways);

}  // namespace hapticell::ergonomics
