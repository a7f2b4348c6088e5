// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// Polygons as a mesh file gives them, before their indices are known to be valid.
struct PolygonSoup {
  std::vector<dvec3> vertices;         ///< In the file's unit.
  std::vector<std::uint32_t> corners;  ///< Vertex indices of all polygons, one after another.
  std::vector<std::uint64_t> ends;     ///< Where each polygon's corners end in `corners`.
  std::vector<std::uint32_t> labels;   ///< Of each polygon, as RawMesh::label; empty: none is named.
  std::vector<Color> vertex_colors;    ///< Empty or one a vertex.
  std::vector<Color> face_colors;      ///< Empty or one a polygon; goes over those of its corners.

  void closePolygon() { ends.push_back(corners.size()); }
};

/// Cuts the polygons into triangles: convex ones as fans, others by ears in their plane. Polygons of fewer than three
/// corners are dropped and such that cross themselves become fans; both are counted in `diagnostics`. Each triangle
/// gets the label and the colour of its polygon. An index out of range is an error that names the polygon.
Expected<RawMesh> triangulate(PolygonSoup soup, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
