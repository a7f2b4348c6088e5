// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/half_edge_counts.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Noncopyable.hh>
#include <span>
#include <vector>

namespace hapticell::geometry {

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Silences what OpenMesh prints for each face that it refuses; we count them.
class QuietOpenMesh {
 public:
  QuietOpenMesh() { omerr().disable(); }
  ~QuietOpenMesh() { omerr().enable(); }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;
};

HalfEdgeMesh buildHalfEdges(const TriangleMesh& mesh, std::span<const Triangle> triangles, std::uint32_t& rejected) {
  const QuietOpenMesh quiet;
  HalfEdgeMesh half_edges;
  std::vector<HalfEdgeMesh::VertexHandle> handles;
  handles.reserve(mesh.vertices.size());
  for (const dvec3& p : mesh.vertices) handles.push_back(half_edges.add_vertex({p.x, p.y, p.z}));
  for (const Triangle& t : triangles) {
    const bool degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (degenerate || !half_edges.add_face(handles[t[0]], handles[t[1]], handles[t[2]]).is_valid()) ++rejected;
  }
  return half_edges;
}

std::uint32_t countShells(const HalfEdgeMesh& mesh) {
  std::vector<bool> seen(mesh.n_faces(), false);
  std::vector<HalfEdgeMesh::FaceHandle> open;
  std::uint32_t shells = 0;
  for (const auto face : mesh.faces()) {
    if (seen[static_cast<std::size_t>(face.idx())]) continue;
    ++shells;
    open.push_back(face);
    seen[static_cast<std::size_t>(face.idx())] = true;
    while (!open.empty()) {
      const auto current = open.back();
      open.pop_back();
      for (const auto next : mesh.ff_range(current)) {
        if (seen[static_cast<std::size_t>(next.idx())]) continue;
        seen[static_cast<std::size_t>(next.idx())] = true;
        open.push_back(next);
      }
    }
  }
  return shells;
}

void countBorders(const HalfEdgeMesh& mesh, Topology& topology) {
  std::vector<bool> seen(mesh.n_halfedges(), false);
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[static_cast<std::size_t>(start.idx())]) continue;
    ++topology.holes;
    HalfEdgeMesh::HalfedgeHandle at = start;
    while (!seen[static_cast<std::size_t>(at.idx())]) {
      seen[static_cast<std::size_t>(at.idx())] = true;
      ++topology.border_edges;
      at = mesh.next_halfedge_handle(at);
    }
  }
}

}  // namespace

Topology halfEdgeCounts(const TriangleMesh& mesh, std::span<const Triangle> triangles) {
  Topology topology;
  const HalfEdgeMesh half_edges = buildHalfEdges(mesh, triangles, topology.rejected_triangles);
  topology.shells = countShells(half_edges);
  countBorders(half_edges, topology);
  std::size_t used_vertices = 0;
  for (const auto vertex : half_edges.vertices()) used_vertices += half_edges.is_isolated(vertex) ? 0u : 1u;
  topology.euler_characteristic =
      static_cast<int>(used_vertices) - static_cast<int>(half_edges.n_edges()) + static_cast<int>(half_edges.n_faces());
  return topology;
}

}  // namespace hapticell::geometry
