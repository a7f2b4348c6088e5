// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::collision {

/// Which way the triangles of a mesh face, judged by what they enclose and not by their order of corners.
struct MeshFacing {
  geometry::TriangleMesh mesh;  ///< As given, but with some triangles turned; same order, same vertices.
  std::size_t turned_triangles = 0;
  std::size_t bodies_turned = 0;  ///< Connected surfaces of which more than half of the area was turned.
  /// Triangles of open sheets: surfaces that enclose nothing, so that both sides are outside. All triangles of a sheet
  /// face the same way. Connected ones have the same number; kNone: not a sheet.
  std::vector<std::uint32_t> sheet_of;
  std::uint32_t sheets = 0;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
};

/// Turns every surface of the soup the way it must face for the material to be behind it.
///
/// First each connected surface is made to face one way throughout, across edges of two triangles; if that is
/// impossible (a Moebius strip), it is unchanged. A closed surface then faces outward by its signed volume. A surface
/// inside another is turned together with it, so that a cavity stays a cavity; inside a cavity it faces outward again.
/// An open surface is judged by the generalised winding number (Jacobson, Kavan, Sorkine-Hornung 2013) of all open
/// surfaces, in front of its triangles: near 0 it is a solid with gaps, near -1 a solid turned inside out, in between a
/// sheet. Any soup is allowed (indices in range, coordinates finite). Any thread.
MeshFacing facingOf(const geometry::TriangleMesh& mesh);

/// The same mesh with each sheet made a plate of `thickness` (m), half of it on either side, closed along its borders.
/// All other triangles stay; those of sheets are replaced, at the end of the list. 0 chooses 1/50000 of the size, at
/// least 20 um, so that every tolerance distinguishes the two sides.
geometry::TriangleMesh withSheetsAsPlates(const MeshFacing& facing, double thickness = 0.0);

/// Both steps, for meshes that are felt; returns the same mesh if nothing had to change.
geometry::TriangleMesh feltMesh(const geometry::TriangleMesh& mesh, std::size_t* bodies_turned = nullptr);

}  // namespace hapticell::collision
