// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/display_mesh.h"

namespace hapticell::app {

/// Appends coarser and coarser triangles to `mesh`, each a quarter of the one before at most, until few are left.
///
/// Edges are collapsed by quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics",
/// 1997) as meshoptimizer does it; the last step may be a clustering without regard to topology (Rossignac and Borrel,
/// "Multi-resolution 3D approximations for rendering complex scenes", 1993), so that wire fences get coarse too.
/// Vertices are shared by all steps. Any thread; some 0.5 s a million triangles.
void addDetailSteps(DisplayMesh& mesh);

/// The coarsest step whose deviation is seen under `pixels` pixels, `metres_per_pixel` being the least over the part.
std::size_t detailStepFor(const std::vector<DetailStep>& steps, double metres_per_pixel, double pixels);

}  // namespace hapticell::app
