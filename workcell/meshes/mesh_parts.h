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
  std::string name;      ///< As the file has it; empty where it names nothing.
  std::string assembly;  ///< Of the object that this is one of several pieces of, with `assembly_number`; else empty.
  std::size_t assembly_number = 0;
  std::optional<Color> color;
  geometry::TriangleMesh mesh;
};

/// Cuts a file into its solids: its objects and groups, and within these what has a colour of its own, but never a skin
/// that hangs together: pieces that share a corner at open borders (patches of one surface, as CAD programs write them)
/// are one solid. A solid of several colours gets that of most of its area; where a file has more than 64 colours (a
/// scan) nothing is cut by them and each solid gets the mean over its area. Both are reported, and how many pieces were
/// joined. More than 10 000 solids, or `split` false: all is one.
///
/// `materials`: colours by name for RawMesh::labels; a face's own colour goes over it. The parts' meshes are in the
/// file's unit and not welded, in the order of their first triangles; together they have all triangles of `raw`.
std::vector<MeshPart> partsOf(RawMesh raw, const std::map<std::string, Color>& materials, bool split,
                              Diagnostics& diagnostics);

}  // namespace hapticell::workcell
