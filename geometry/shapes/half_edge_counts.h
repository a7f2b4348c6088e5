// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/shapes/topology.h"

namespace hapticell::geometry {

/// The counts of `triangles`, whose corners are vertices of `mesh`, in a temporary half-edge mesh of OpenMesh: of any
/// triangles, in the order given. topologyOf() uses it where a surface is not plain.
Topology halfEdgeCounts(const TriangleMesh& mesh, std::span<const Triangle> triangles);

}  // namespace hapticell::geometry
