// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// Appends coarser and coarser triangles to `mesh`, each some third of the one before, until few are left or the shape
/// would suffer.
///
/// Edges are collapsed by quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics",
/// 1997) as meshoptimizer does it, with open borders locked; where that leaves many triangles (wire fences) the last
/// step gathers vertices (vertex_clusters.h). Quadrics are means over areas and tell little of a small hole in a large
/// plate, so what a step is off is measured between the surfaces, both ways. Each step has normals of its own, smoothed
/// at less than `crease_angle`: those of the whole mesh would smear over its larger triangles.
/// Any thread; some 3 s a million triangles. Stops between pieces of some 0.3 s once `given_up` is set.
void addDetailSteps(DisplayMesh& mesh, double crease_angle = kPartCrease, const std::atomic<bool>* given_up = nullptr);

/// The coarsest step whose deviation is seen under `pixels` pixels, `metres_per_pixel` being the least over the part.
std::size_t detailStepFor(const std::vector<DetailStep>& steps, double metres_per_pixel, double pixels);

}  // namespace hapticell::app
