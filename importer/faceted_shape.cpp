// SPDX-License-Identifier: Apache-2.0
#include "importer/faceted_shape.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>
#include <unordered_map>
#include <vector>

#include "geometry/shapes/mass_properties.h"

namespace hapticell::importer {

namespace {

// mm: a hundred times OpenCASCADE's own 1e-7, for vertices that are rounded. Half: more edges that it calls open;
// twice: no effect on parts.
constexpr double kTolerance_mm = 1e-5;

class FacetBuilder {
 public:
  explicit FacetBuilder(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
    for (const dvec3& p : mesh.vertices) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, gp_Pnt(1e3 * p.x, 1e3 * p.y, 1e3 * p.z), kTolerance_mm);
      vertices_.push_back(vertex);
    }
  }

  TopoDS_Shell shell(int& faces) {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const geometry::Triangle& t : mesh_.triangles) {
      const TopoDS_Face face = faceOf(t);
      if (face.IsNull()) continue;
      builder_.Add(shell, face);
      ++faces;
    }
    return shell;
  }

 private:
  /// The edge between two vertices, in that direction.
  TopoDS_Edge edge(std::uint32_t from, std::uint32_t to) {
    const bool turned = from > to;
    const std::uint64_t key = (std::uint64_t{std::min(from, to)} << 32) | std::max(from, to);
    auto [known, is_new] = edges_.try_emplace(key);
    if (is_new) {
      BRepBuilderAPI_MakeEdge make(vertices_[std::min(from, to)], vertices_[std::max(from, to)]);
      if (make.IsDone()) known->second = make.Edge();
    }
    if (known->second.IsNull()) return known->second;
    return TopoDS::Edge(known->second.Oriented(turned ? TopAbs_REVERSED : TopAbs_FORWARD));
  }

  TopoDS_Face faceOf(const geometry::Triangle& t) {
    const gp_Pnt a = BRep_Tool::Pnt(vertices_[t[0]]), b = BRep_Tool::Pnt(vertices_[t[1]]),
                 c = BRep_Tool::Pnt(vertices_[t[2]]);
    const gp_Vec normal = gp_Vec(a, b).Crossed(gp_Vec(a, c));
    if (!(normal.Magnitude() > 1e-14)) return {};
    const TopoDS_Edge ab = edge(t[0], t[1]), bc = edge(t[1], t[2]), ca = edge(t[2], t[0]);
    if (ab.IsNull() || bc.IsNull() || ca.IsNull()) return {};
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const TopoDS_Edge& part : {ab, bc, ca}) builder_.Add(wire, part);
    wire.Closed(true);
    const BRepBuilderAPI_MakeFace make(gp_Pln(a, gp_Dir(normal)), wire, true);
    return make.IsDone() ? make.Face() : TopoDS_Face();
  }

  const geometry::TriangleMesh& mesh_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::unordered_map<std::uint64_t, TopoDS_Edge> edges_;
};

}  // namespace

TopoDS_Shape facetedShape(const geometry::TriangleMesh& mesh) {
  int faces = 0;
  TopoDS_Shell shell = FacetBuilder(mesh).shell(faces);
  if (faces == 0) return {};
  if (!geometry::isClosed(mesh)) return shell;
  shell.Closed(true);
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

}  // namespace hapticell::importer
