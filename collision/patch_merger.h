// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "collision/surface_patches.h"

namespace hapticell::collision {

/// Every triangle of the patch lies on the convex hull of the patch, facing outward.
bool isConvexSurface(const SurfaceGraph& graph, const Patch& patch);

/// Cuts one connected component that is not convex: starts from single triangles and joins neighbours across edges that
/// are not concave, flat ones first, then by length of the shared border, as long as the hull of the union holds
/// no other surface deeper than the tolerance and all joined triangles stay on the hull.
std::vector<Patch> mergedPatches(const SurfaceGraph& graph, const Patch& component);

}  // namespace hapticell::collision
