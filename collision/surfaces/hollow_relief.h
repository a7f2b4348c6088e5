// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/surfaces/recognised_surface.h"

namespace hapticell::collision {

/// How far (m) the facets of a region are sunk into the material so that they stay behind its surface: the sagitta of
/// what is hollow and 6 % more, at most 0.1 mm; 0 for everything else.
double reliefOf(const SurfaceRegion& region);

/// The mesh with the vertices of its hollows moved into the material by their relief. Facets of a hollow stand inside
/// its surface by the sagitta, so a peg that fits the bore would be refused by the bore's facets; those of this mesh
/// are never in front of the surface. Same vertices and triangles otherwise.
geometry::TriangleMesh relievedMesh(const RecognisedSurface& surface);

/// Whether relievedMesh() differs from the mesh at all.
bool hasHollows(const RecognisedSurface& surface);

}  // namespace hapticell::collision
