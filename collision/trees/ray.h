// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/oriented_box.h"

namespace hapticell::collision {

/// A half line from `origin` along `direction` (any length but zero), in the same frame as what it meets.
struct Ray {
  dvec3 origin{0.0};
  dvec3 direction{1.0, 0.0, 0.0};
};

/// How a ray meets a triangle.
struct RayCrossing {
  bool meets = false;
  bool grazes = false;   ///< Through an edge or corner, or along the face, up to rounding: `meets` is unreliable.
  bool leaving = false;  ///< Meets the back of the face (the clockwise side).
  double along = 0.0;    ///< In multiples of the direction's length. Where it grazes: the place on the triangle's plane;
                         ///< infinite if the triangle is seen edge-on or is behind the origin, or if nothing is met.
};

/// Whether the ray meets the box nearer than `farthest` (in multiples of the direction's length); `entry` is then the
/// place.
bool meetsBox(const Ray& ray, const OrientedBox& box, double farthest, double& entry);

/// Signed volumes of the ray's line with the three edges decide (Segura & Feito 2001).
RayCrossing meetTriangle(const Ray& ray, const Corners& corners);

}  // namespace hapticell::collision
