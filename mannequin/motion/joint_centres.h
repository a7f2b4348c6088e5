// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"

namespace hapticell::mannequin {

// Where joints lie beside the markers on the skin. World, m; one frame.

/// 0 for what has no length.
inline dvec3 unitOf(const dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : dvec3(0.0);
}

/// The direction of what of `v` is square to the unit vector `axis`.
inline dvec3 square(const dvec3& v, const dvec3& axis) {
  return unitOf(v - glm::dot(v, axis) * axis);
}

/// Columns forward, left, up, from the first two roughly or the last two.
inline dmat3 fromUp(const dvec3& up, const dvec3& left) {
  const dvec3 z = unitOf(up), y = square(left, z);
  return {glm::cross(y, z), y, z};
}

inline dmat3 fromForward(const dvec3& forward, const dvec3& left) {
  const dvec3 x = unitOf(forward), y = square(left, x);
  return {x, y, glm::cross(x, y)};
}

/// To the left, across a knee or an elbow: by its bend, where it is bent, else as the trunk's.
dvec3 hingeAxis(const dvec3& from, const dvec3& middle, const dvec3& to, double bends, const dvec3& otherwise);
/// Outwards from a hinge's centre to the marker on its outside, square to both bones: the centre is that far from the
/// marker that the line of the outer ends and the marker tell, and bends the right way. `turn`: the sign of the cross
/// product of both bones along the outward axis.
dvec3 hingeOutward(const dvec3& from, const dvec3& marker, const dvec3& to, double offset, double turn);
/// A joint's centre inside its outer marker, square to the bone and in the plane of a marker on the bone's outside,
/// as Plug-in Gait has it.
dvec3 centreInside(const dvec3& above, const dvec3& marker, const dvec3& plane, double offset);

}  // namespace hapticell::mannequin
