// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// A closed mesh without its hollows: surfaces that are turned inside out and so enclose nothing (bubbles within a
/// solid), with their vertices. What remains keeps its order.
TriangleMesh withoutHollows(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
