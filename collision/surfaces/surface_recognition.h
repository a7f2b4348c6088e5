// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

struct RecognitionOptions {
  std::filesystem::path cache_folder{};  ///< What was found is kept here by the mesh's content; empty keeps nothing.
  double tolerance = 0.0;  ///< m that vertices may be off a surface; 0: 1 um, at least 2e-6 of the mesh's diagonal.
  const std::atomic<bool>* cancelled = nullptr;  ///< Set by anyone to end it soon; what is left is free form then.
};

/// Finds the planes, cylinders, cones, spheres and tori that a mesh was made from.
///
/// The vertices of a tessellation lie on the true surface, so surfaces are fitted to vertices, within the tolerance
/// (first a tenth of it): planes by flooding from the largest triangle; the others from small neighbourhoods of
/// triangles (closed-form start, damped least squares), grown over smooth edges while vertices and middles of edges
/// agree; of several that fit, the one whose edges' middles are nearest. Fitting: Eberly, "Least squares fitting of
/// data" (1999); growing: Benko, Martin, Varady, "Algorithms for reverse engineering boundary representation models"
/// (2001). What fits none becomes a free-form region. Any soup is taken (indices in range, coordinates finite). Any
/// thread.
RecognisedSurface recogniseSurfaces(const geometry::TriangleMesh& mesh, const RecognitionOptions& options = {});

}  // namespace hapticell::collision
