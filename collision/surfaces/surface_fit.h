// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// What a surface is fitted to: vertices that lie on it, and facets near it for the start. Frame M, metres.
struct FitSample {
  std::span<const dvec3> points;
  std::span<const dvec3> facet_points;   ///< One of each facet's plane (its middle).
  std::span<const dvec3> facet_normals;  ///< Unit, outward; as many.
};

/// The surface of this type nearest to the points, or nothing where some point is farther than `tolerance` (m) from
/// it. Closed-form start, then damped least squares (Levenberg-Marquardt); a start that is off by more than a tenth of
/// the sample's extent is given up at once. The side is that of the facets' normals. Planes and free form: nothing.
std::optional<SurfaceShape> fitSurface(SurfaceType type, const FitSample& sample, double tolerance);

/// Improves the surface over the points by damped least squares; returns the greatest distance (m) that is left.
double refineSurface(SurfaceShape& shape, std::span<const dvec3> points, double tolerance);

/// Greatest |signedDistance| of the points, m.
double greatestDistance(const SurfaceShape& shape, std::span<const dvec3> points);

}  // namespace hapticell::collision
