// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// Appends coarser and coarser triangles to `mesh`, each step with about a third of the triangles before, until few are
/// left or the shape would suffer.
///
/// Edges are collapsed by quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics",
/// 1997) with meshoptimizer, with open borders locked; if that leaves many triangles (wire fences), the last step
/// clusters vertices (vertex_clusters.h). Quadrics are means over areas and hardly notice a small hole in a large
/// plate, so the deviation of a step is measured between the surfaces, both ways. Each step has its own normals,
/// smoothed below `crease_angle`: those of the whole mesh would smear over larger triangles.
/// Any thread; about 3 s per million triangles. Stops within about 0.3 s once `given_up` is set.
void addDetailSteps(DisplayMesh& mesh, double crease_angle = kPartCrease, const std::atomic<bool>* given_up = nullptr);

/// The coarsest step with a deviation below `pixels` pixels; `metres_per_pixel` is the smallest value over the part.
std::size_t detailStepFor(const std::vector<DetailStep>& steps, double metres_per_pixel, double pixels);

}  // namespace hapticell::app
