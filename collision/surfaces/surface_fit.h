// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// Input of a fit: vertices on the surface, and facets near it for the start. Frame M, metres.
struct FitSample {
  std::span<const dvec3> points;
  std::span<const dvec3> facet_points;   ///< One of each facet's plane (its middle).
  std::span<const dvec3> facet_normals;  ///< Unit, outward; one per facet point.
};

/// The surface of this type nearest to the points; empty if some point is farther than `tolerance` (m) from it.
/// Closed-form start, then damped least squares (Levenberg-Marquardt); if the start deviates by more than a tenth of
/// the sample's extent, the fit is given up at once. The side follows the facets' normals. For planes and free form the
/// result is empty.
std::optional<SurfaceShape> fitSurface(SurfaceType type, const FitSample& sample, double tolerance);

/// Improves the surface over the points by damped least squares; returns the greatest remaining distance (m).
double refineSurface(SurfaceShape& shape, std::span<const dvec3> points, double tolerance);

/// Greatest |signedDistance| of the points, m.
double greatestDistance(const SurfaceShape& shape, std::span<const dvec3> points);

}  // namespace hapticell::collision
