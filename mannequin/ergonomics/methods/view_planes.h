// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/vector.h"

namespace hapticell::ergonomics {

/// The planes in which a limb or the trunk is viewed. Unit vectors, perpendicular to each other, in any one frame.
struct ViewPlanes {
  dvec3 forward{1, 0, 0};
  dvec3 outward{0, 1, 0};  ///< Of the trunk to its left; of an arm away from the trunk.
  dvec3 up{0, 0, 1};
};

/// A line of the body relative to its zero direction, degrees.
struct PlaneAngles {
  double flexion = 0.0;    ///< Seen from the side, forward positive.
  double sideways = 0.0;   ///< Out of the sagittal plane, outward positive; -90 to 90.
  double elevation = 0.0;  ///< The total angle in any direction; 0 to 180.
};

/// The trunk from hips to neck, `line` of any length but 0: flexion from upright, -180 to 180. A line straight to a
/// side has no flexion: within 11.5 deg of that direction flexion fades to 0, because it cannot be seen from the side.
PlaneAngles trunkAngles(const ViewPlanes& planes, const dvec3& line);

/// The upper arm from shoulder to elbow: flexion from hanging along the trunk; negative behind it. This is the angle
/// seen from the side up to 78.7 deg outward; farther out the side view is short, and flexion fades to 0 for an arm
/// straight out to the side. An arm above shoulder level counts by its elevation, in whatever direction it was raised:
/// over the first 15 deg above level, flexion changes to that. The result is continuous in all directions, 180 for
/// straight up.
PlaneAngles upperArmAngles(const ViewPlanes& planes, const dvec3& line);

/// Elevation of an arm of which flexion and sideways angle are known, degrees: the inverse for arms below level.
double armElevation(double flexion, double sideways);

}  // namespace hapticell::ergonomics
