// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "collision/pieces/convex_hull.h"
#include "collision/trees/mesh_collider.h"
#include "collision/pieces/surface_patches.h"

namespace hapticell::collision {

/// Every triangle of the patch lies on the convex hull of the patch, facing outward.
bool isConvexSurface(const SurfaceGraph& graph, const Patch& patch);

/// The hull of a patch; a flat one gets a thickness of four tolerances behind its surface. Nothing where rounding
/// spoils it.
std::optional<ConvexHull> hullOfPatch(const SurfaceGraph& graph, const Patch& patch);

/// The same for a closed patch that isConvexSurface, straight from its triangles: for large ones that quickhull is too
/// slow or not robust enough for. Nothing where the patch has a border.
std::optional<ConvexHull> hullOfConvexSurface(const SurfaceGraph& graph, const Patch& patch);

/// Cuts connected components that are not convex: starts from single triangles and joins neighbours across edges that
/// are not concave (flat ones first, then the sharpest, then the longest) as long as all joined triangles stay on the
/// hull of the union and that hull holds no other surface deeper than the tolerance. Any set of triangles may stand for
/// a component. `collider` is that of graph.mesh().
std::vector<Patch> mergedPatches(const SurfaceGraph& graph, std::span<const Patch> components,
                                 const MeshCollider& collider);

}  // namespace hapticell::collision
