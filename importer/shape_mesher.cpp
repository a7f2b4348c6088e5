// SPDX-License-Identifier: Apache-2.0
#include "importer/shape_mesher.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <map>

namespace hapticell::importer {

namespace {

double diagonalOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddClose(shape, box);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

/// Appends a face's triangles; their area, or nothing where it has none.
std::optional<double> appendFace(const TopoDS_Face& face, double metres, geometry::TriangleMesh& mesh) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
  if (triangulation.IsNull() || triangulation->NbTriangles() == 0) return std::nullopt;
  const gp_Trsf transform = location.Transformation();
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int k = 1; k <= triangulation->NbNodes(); ++k) {
    const gp_Pnt p = triangulation->Node(k).Transformed(transform);
    mesh.vertices.push_back(dvec3(p.X(), p.Y(), p.Z()) * metres);
  }
  const bool turned = (face.Orientation() == TopAbs_REVERSED) != transform.IsNegative();
  double area = 0.0;
  for (int k = 1; k <= triangulation->NbTriangles(); ++k) {
    int a = 0, b = 0, c = 0;
    triangulation->Triangle(k).Get(a, b, c);
    if (turned) std::swap(b, c);
    const auto index = [first](int node) { return first + static_cast<std::uint32_t>(node - 1); };
    mesh.triangles.push_back({index(a), index(b), index(c)});
    const auto triangle = static_cast<std::uint32_t>(mesh.triangles.size() - 1);
    const dvec3 p = mesh.corner(triangle, 0);
    area += glm::length(glm::cross(mesh.corner(triangle, 1) - p, mesh.corner(triangle, 2) - p));
  }
  return area;
}

}  // namespace

std::array<float, 3> plainColor(const Quantity_Color& color) {
  double r = 0.0, g = 0.0, b = 0.0;
  color.Values(r, g, b, Quantity_TOC_sRGB);
  const auto part = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  return {part(r), part(g), part(b)};
}

MeshedShape meshShape(const TopoDS_Shape& shape, double factor, const workcell::Tessellation& tessellation,
                      const FaceColors& colors) {
  // Of the size: a finer chord only fills the memory: 0.01 mm of a part of 1 m. Half: 1.4 times as many cuts of a
  // circle; twice: 0.02 mm is the finest.
  constexpr double kFinest = 1e-5;
  const double chord_mm = std::max(tessellation.chord * 1e3 / factor, kFinest * diagonalOf(shape));
  const BRepMesh_IncrementalMesh mesher(shape, chord_mm, false, tessellation.angle, true);
  MeshedShape result;
  std::map<std::array<float, 3>, double> area_of;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    ++result.faces;
    const std::optional<double> area = appendFace(face, 1e-3 * factor, result.mesh);
    if (!area) ++result.missing_faces;
    if (const Quantity_Color* color = colors.Seek(face)) area_of[plainColor(*color)] += area.value_or(0.0);
  }
  double most = -1.0;
  for (const auto& [color, area] : area_of) {
    if (area > most) result.color = color;
    most = std::max(most, area);
  }
  result.several_colors = area_of.size() > 1;
  return result;
}

}  // namespace hapticell::importer
