// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <NCollection_DataMap.hxx>
#include <Quantity_Color.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <optional>
#include <string>

#include "geometry/shapes/triangle_mesh.h"
#include "workcell/entity/import_options.h"

namespace hapticell::importer {

using FaceColors = NCollection_DataMap<TopoDS_Shape, Quantity_Color, TopTools_ShapeMapHasher>;

/// A shape as triangles, metres.
struct MeshedShape {
  geometry::TriangleMesh mesh;
  int faces = 0;
  int missing_faces = 0;                      ///< Could not be meshed.
  std::optional<std::array<float, 3>> color;  ///< The colour with the largest area, sRGB.
  bool several_colors = false;
};

/// Meshes a shape (millimetres) and scales it by `factor` to the chosen size. Corners of neighbouring faces are not
/// merged. The chord error is raised to at least 1e-5 of the shape's diagonal.
MeshedShape meshShape(const TopoDS_Shape& shape, double factor, const workcell::Tessellation& tessellation,
                      const FaceColors& colors);

/// The numbers as in the file (OpenCASCADE stores them linear).
std::array<float, 3> plainColor(const Quantity_Color& color);

}  // namespace hapticell::importer
