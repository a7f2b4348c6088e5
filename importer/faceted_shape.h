// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Shape.hxx>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::importer {

/// A shape (millimetres) with one plane face per triangle; neighbours share their edges. A solid if the mesh is closed,
/// else a shell. The mesh should be welded. Null if no triangle has an area.
TopoDS_Shape facetedShape(const geometry::TriangleMesh& mesh);

}  // namespace hapticell::importer
