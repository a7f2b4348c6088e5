// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "geometry/shapes/vector.h"

namespace hapticell::collision {

/// The corners of one triangle, all in one frame; it may be degenerate (a segment or a point).
using Corners = std::array<dvec3, 3>;

/// Two points and the square of their distance.
struct NearestPair {
  double squared = std::numeric_limits<double>::infinity();
  dvec3 p{0.0};  ///< On the first triangle.
  dvec3 q{0.0};  ///< On the second.
};

/// If the two triangles are nearer to each other than `best`, updates `best` and returns true.
///
/// Intersecting triangles give 0 and one common point. After Lumelsky, "On fast computation of distance between line
/// segments" (1985), and Ericson, "Real-Time Collision Detection" (2005): the least distance of 9 edge pairs and of 6
/// corners above the other's face; 0 if an edge pierces a face.
bool improveTriangleDistance(const Corners& first, const Corners& second, NearestPair& best);

/// The nearest pair of two triangles.
NearestPair triangleDistance(const Corners& first, const Corners& second);

/// The point of a triangle nearest to `point`.
dvec3 closestPointOnTriangle(const Corners& corners, const dvec3& point);

}  // namespace hapticell::collision
