// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/triangle_distance.h"
#include "geometry/shapes/vector.h"

namespace hapticell::collision {

/// An oriented box in some frame F.
struct OrientedBox {
  dmat3 R{1.0};       ///< Columns: the box's axes in F.
  dvec3 center{0.0};  ///< In F, metres.
  dvec3 half{0.0};    ///< Half sizes along the axes, metres.
};

/// The same box in A, by the rotation and position of F in A.
OrientedBox moved(const dmat3& R_AF, const dvec3& p_AF, const OrientedBox& box_F);

/// A lower bound of the squared distance of two boxes (both in one frame): the larger of the gap vectors' norms in the
/// two boxes' own axes.
double lowerBoundSquared(const OrientedBox& a, const OrientedBox& b);

/// The square of the distance from a point to a box.
double lowerBoundSquared(const OrientedBox& box, const dvec3& point);

/// A lower bound for a triangle and a box: their gap along the line from the triangle to the box's middle. Tight if the
/// box is smaller than the triangle.
double lowerBoundSquared(const OrientedBox& box, const Corners& triangle);

}  // namespace hapticell::collision
