// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::access {

/// The mesh with every face moved inwards by `by` (m), so that parts that only touch are apart. Corners go where the
/// moved faces meet; at edges sharper than about 30 deg they go four times as far at most, so the faces there move less.
/// Reduced where the mesh's box is thinner than ten times that. Triangles keep their indices. Any thread.
geometry::TriangleMesh thinned(const geometry::TriangleMesh& mesh, double by);

}  // namespace hapticell::access
