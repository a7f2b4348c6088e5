// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// An upper bound (m) of how far any point of a body moves from X_WB0 to X_WB1 when it lies within `radius` (m) of
/// p_BS: the shift of S plus the chord of the turn at that radius. The order of the poses does not matter.
double motionBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius);

/// Only the rotation's part of that bound, m: the chord of the rotation at the radius.
double turnBound(const Pose& X_WB0, const Pose& X_WB1, double radius);

/// A rotation from X_WB0 to X_WB1: what a point of the body at r from the middle (in the world) goes is w_W x r, and
/// besides at most `bent` times the length of r; in all at most `chord` times it.
struct Turn {
  dvec3 w_W{0.0};
  double bent = 0.0, chord = 0.0;
};
Turn turnOf(const Pose& X_WB0, const Pose& X_WB1);

/// The body of a pair whose sphere bounds the relative motion. The smaller body is taken, so that a rotation of a small
/// part inside a large one counts with the small radius.
struct MotionLever {
  dvec3 p{0.0};         ///< The sphere's centre, in that body's frame,
  double radius = 0.0;  ///< and radius, m.
  bool is_a = false;
};
MotionLever leverOf(const MeshCollider& a, const MeshCollider& b);

/// An upper bound (m) of how far any point of that body moves as seen from the other one, while B goes from X_AB0 to
/// X_AB1: no distance between the two bodies changes by more.
double motionBound(const MotionLever& lever, const Pose& X_AB0, const Pose& X_AB1);

/// An upper bound (m) of the length of the path of any such point along interpolate(X_WB0, X_WB1, s), s from 0 to 1.
double pathBound(const Pose& X_WB0, const Pose& X_WB1, const dvec3& p_BS, double radius);

}  // namespace hapticell::collision
