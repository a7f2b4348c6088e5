// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/oriented_box.h"

namespace hapticell::collision {

/// A half line from `origin` along `direction` (any length but zero), in one frame with what it meets.
struct Ray {
  dvec3 origin{0.0};
  dvec3 direction{1.0, 0.0, 0.0};
};

/// How a ray meets a triangle.
struct RayCrossing {
  bool meets = false;
  bool grazes = false;   ///< Through an edge or corner, or along the face, to rounding: do not count on `meets`.
  bool leaving = false;  ///< Meets the face from its back (the clockwise side).
  double along = 0.0;    ///< In lengths of the direction.
};

/// Whether the ray meets the box nearer than `farthest` (in lengths of the direction); `entry` is then where.
bool meetsBox(const Ray& ray, const OrientedBox& box, double farthest, double& entry);

/// Signed volumes of the ray's line with the three edges decide (Segura & Feito 2001).
RayCrossing meetTriangle(const Ray& ray, const Corners& corners);

}  // namespace hapticell::collision
