// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

// The readers behind readMeshFile, one per format: from content to triangles in the file's own unit, with the file's
// names and colours, without welding. Errors have the position but not the file's name. They read nothing but
// `content`, and allocate no more than its length justifies.

/// True if the length is that of a binary STL: 84 bytes plus 50 per triangle.
bool hasLengthOfBinaryStl(std::string_view content);

Expected<RawMesh> readStlAscii(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readStlBinary(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readObj(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readPly(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readOff(std::string_view content, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
