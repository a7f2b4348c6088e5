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

/// The hull of a patch; a flat one gets a thickness of four tolerances behind its surface. Empty if rounding makes it
/// wrong.
std::optional<ConvexHull> hullOfPatch(const SurfaceGraph& graph, const Patch& patch);

/// The same for a closed patch that isConvexSurface(), directly from its triangles: for large patches, where quickhull
/// is too slow or not robust enough. Empty if the patch has a border.
std::optional<ConvexHull> hullOfConvexSurface(const SurfaceGraph& graph, const Patch& patch);

/// Cuts connected components that are not convex. It starts from single triangles and joins neighbours across edges
/// that are not concave: flat ones first, then the sharpest, then the longest. It joins them only if all joined
/// triangles stay on the hull of the union and that hull contains no other surface deeper than the tolerance. A
/// component may be any set of triangles. `collider` is that of graph.mesh().
std::vector<Patch> mergedPatches(const SurfaceGraph& graph, std::span<const Patch> components,
                                 const MeshCollider& collider);

}  // namespace hapticell::collision
