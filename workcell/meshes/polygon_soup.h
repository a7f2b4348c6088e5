// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// Polygons of a mesh file, before their indices are known to be valid.
struct PolygonSoup {
  std::vector<dvec3> vertices;         ///< In the file's unit.
  std::vector<std::uint32_t> corners;  ///< Vertex indices of all polygons, one after another.
  std::vector<std::uint64_t> ends;     ///< End of each polygon's corners in `corners`.
  std::vector<std::uint32_t> labels;   ///< For each polygon, as RawMesh::label; empty: no names.
  std::vector<Color> vertex_colors;    ///< Empty, or one per vertex.
  std::vector<Color> face_colors;      ///< Empty, or one per polygon; overrides the colours of its corners.

  void closePolygon() { ends.push_back(corners.size()); }
};

/// Splits the polygons into triangles: convex ones as fans, others by ear clipping in their plane. Drops polygons with
/// fewer than three corners, and makes fans of those that cross themselves; counts both in `diagnostics`. Each triangle
/// gets the label and the colour of its polygon. Error: an index out of range, with the polygon.
Expected<RawMesh> triangulate(PolygonSoup soup, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
