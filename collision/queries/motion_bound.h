// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// An upper bound (m) of how far any point of a body moves from X_WB0 to X_WB1 when it lies within `radius` (m) of
/// p_BS: the shift of S plus the chord of the turn at that radius. The order of the poses does not matter.
double motionBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius);

/// An upper bound (m) of the length of the path of any such point along interpolate(X_WB0, X_WB1, s), s from 0 to 1.
double pathBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius);

}  // namespace hapticell::collision
