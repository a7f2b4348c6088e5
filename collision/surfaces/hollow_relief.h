// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// How far (m) the facets of a region are moved into the material so that they stay behind its surface: for hollow
/// regions the sagitta plus 6 %, at most 0.1 mm; 0 for all other regions.
double reliefOf(const SurfaceRegion& region);

/// The mesh with the vertices of its hollow regions moved into the material by their relief. Facets of a bore are in
/// front of its true surface by the sagitta, so a peg that fits the bore would collide with them. The facets of this
/// mesh are never in front of the surface. Everything else is unchanged.
geometry::TriangleMesh relievedMesh(const RecognisedSurface& surface);

/// Whether relievedMesh() differs from the mesh at all.
bool hasHollows(const RecognisedSurface& surface);

}  // namespace hapticell::collision
