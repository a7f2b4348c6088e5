// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Which way the triangles of a mesh face, told by what they enclose and not by how they were written.
struct MeshFacing {
  geometry::TriangleMesh mesh;  ///< As given, but for the turn of some triangles: same order, same vertices.
  std::size_t turned_triangles = 0;
  std::size_t bodies_turned = 0;  ///< Connected surfaces of which that is the greater part of the area.
  /// Triangles of open sheets: surfaces that enclose nothing, so that both sides are outside. Each sheet is turned the
  /// same way throughout. Connected ones have the same number; kNone: no sheet.
  std::vector<std::uint32_t> sheet_of;
  std::uint32_t sheets = 0;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
};

/// Turns every surface of the soup the way it must face for the material to be behind it.
///
/// First each connected surface is made to face one way throughout (over edges of two triangles; one that cannot, as a
/// Moebius strip, is left as it is). A closed one then faces outward by its signed volume; one that lies within another
/// is turned with that, so that a cavity stays one, and within a cavity it faces outward again. An open one is judged
/// by the generalised winding number (Jacobson, Kavan, Sorkine-Hornung 2013) of all open ones in front of its
/// triangles: near 0, it is a solid with gaps; near -1, the same turned inside out; in between, a sheet. Any soup is
/// taken (indices in range, coordinates finite). Any thread.
MeshFacing facingOf(const geometry::TriangleMesh& mesh);

/// The same mesh with each sheet made a plate of `thickness` (m), half of it on either side, closed along its borders.
/// What is no sheet keeps its triangles; those of sheets are replaced at the end. With 0: a fifty-thousandth of the
/// size, at least 20 um, so that everything that tells surfaces apart tells its two sides apart.
geometry::TriangleMesh withSheetsAsPlates(const MeshFacing& facing, double thickness = 0.0);

/// Both, for what is to be felt: the mesh itself where nothing had to be done.
geometry::TriangleMesh feltMesh(const geometry::TriangleMesh& mesh, std::size_t* bodies_turned = nullptr);

}  // namespace hapticell::collision
