// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// One solid of a mesh file.
struct MeshPart {
  std::string name;      ///< As in the file; empty if the file gives no name.
  std::string assembly;  ///< The object that this is a piece of, with `assembly_number`; else empty.
  std::size_t assembly_number = 0;
  std::optional<Color> color;
  geometry::TriangleMesh mesh;
};

/// Splits a file into its solids: its objects and groups, and within these, areas with their own colour, but never a
/// connected surface: pieces that share a corner at open borders (patches of one surface, as CAD programs write them)
/// are one solid. A solid of several colours gets the one with most of its area; if a file has more than 64 colours (a
/// scan), it is not split by them and each solid gets the mean over its area. Both are reported, and so is the number
/// of joined pieces. With more than 10 000 solids, or if not `split`, the result is one solid.
///
/// `materials`: colours by name for RawMesh::labels; a face's own colour overrides them. The parts' meshes are in the
/// file's unit and not welded, in the order of their first triangles; together they have all triangles of `raw`.
std::vector<MeshPart> partsOf(RawMesh raw, const std::map<std::string, Color>& materials, bool split,
                              Diagnostics& diagnostics);

}  // namespace hapticell::workcell
