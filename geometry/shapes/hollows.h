// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// The closed mesh without its hollows and their vertices. A hollow is a surface that is turned inside out (a bubble
/// within a solid). The other triangles and vertices keep their order.
TriangleMesh withoutHollows(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
