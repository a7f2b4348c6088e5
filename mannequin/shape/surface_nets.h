// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::mannequin {

/// Values of a field on a grid, evaluated for whole blocks so that the field can select the relevant parts.
struct GridField {
  geometry::Bounds bounds;  ///< Bounds of the surface.
  double cell = 0.01;       ///< m
  /// Approximate distance to the surface at all of `points`, into `values`; `centre` and `radius` bound the points.
  std::function<void(const dvec3& centre, double radius, const std::vector<dvec3>& points, std::vector<double>& values)>
      evaluate;
};

/// The surface where the field is zero, with positive values outside: naive surface nets (S. F. F. Gibson, 1998), a
/// vertex per cell that the surface crosses, at the mean of its crossings.
geometry::TriangleMesh surfaceOf(const GridField& field);

/// Smooths details of the size of the cells without shrinking: G. Taubin, "A signal processing approach to fair surface
/// design" (1995), its pair of steps a few times.
void smoothSkin(geometry::TriangleMesh& mesh);

}  // namespace hapticell::mannequin
