// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

// The readers behind readMeshFile, one a format: content to triangles in the file's own unit with what the file says of
// names and colours, nothing welded. Errors carry the place but not the file's name. They look at nothing but
// `content`, and allocate no more than its length justifies.

/// True when the length is that of a binary STL: 84 bytes and 50 a triangle.
bool hasLengthOfBinaryStl(std::string_view content);

Expected<RawMesh> readStlAscii(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readStlBinary(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readObj(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readPly(std::string_view content, Diagnostics& diagnostics);
Expected<RawMesh> readOff(std::string_view content, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
