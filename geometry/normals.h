// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/feature_edges.h"
#include "geometry/triangle_mesh.h"

namespace hapticell::geometry {

/// Unit normals for smooth shading, three a triangle in the order of its corners: the mean, weighted by the angle at
/// the corner, of the faces that join there without a crease (G. Thuermer, C. A. Wuethrich, "Computing vertex normals
/// from polygonal facets", 1998). Non-manifold edges and borders part them too. The mesh should be welded. A corner of
/// a triangle without area takes what its neighbours say, else z.
std::vector<dvec3> cornerNormals(const TriangleMesh& mesh, double crease_angle = kCreaseAngle);

/// A mesh as a graphics card takes it: a vertex stands once for each different normal it has.
struct ShadedMesh {
  std::vector<fvec3> positions;        ///< Relative to `origin`: single precision suffices there.
  std::vector<fvec3> normals;          ///< One a position.
  std::vector<std::uint32_t> indices;  ///< Three a triangle, in the mesh's order.
  dvec3 origin{0.0};                   ///< p_MO: the centre of the mesh's bounds, in its frame M.
};

ShadedMesh shadedMesh(const TriangleMesh& mesh, double crease_angle = kCreaseAngle);

}  // namespace hapticell::geometry
