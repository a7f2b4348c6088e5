// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

struct RecognitionOptions {
  std::filesystem::path cache_folder{};  ///< Cache for the results, by the mesh's content; empty: no cache.
  double tolerance = 0.0;  ///< Allowed distance (m) of vertices from a surface; 0: 1 um, at least 2e-6 of the mesh's
                           ///< diagonal.
  const std::atomic<bool>* cancelled = nullptr;  ///< Any thread may set it to end early; the rest is then free form.
};

/// Finds the planes, cylinders, cones, spheres and tori from which a mesh was made.
///
/// The vertices of a tessellation lie on the true surface, so surfaces are fitted to vertices, within the tolerance
/// (first a tenth of it): planes by flooding from the largest triangle; the others from small neighbourhoods of
/// triangles (closed-form start, damped least squares), grown across smooth edges while vertices and middles of edges
/// agree. If several surfaces fit, the one nearest to the edges' middles is chosen. Fitting: Eberly, "Least squares
/// fitting of data" (1999); growing: Benko, Martin, Varady, "Algorithms for reverse engineering boundary representation
/// models" (2001). Triangles that fit no surface become free-form regions. Any soup is allowed (indices in range,
/// coordinates finite). Any thread.
RecognisedSurface recogniseSurfaces(const geometry::TriangleMesh& mesh, const RecognitionOptions& options = {});

}  // namespace hapticell::collision
