// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/system/error.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

class SceneBatch;
struct MeshFileParts;

/// The whole content of a mesh or CAD file as one mesh in the file's frame, metres. `metres_per_unit` as in
/// ImportOptions; a size that suggests another unit is not reported. `batch` (may be null) has the scenes that were
/// read ahead, with its own options. Errors as for readMeshFile() and readScene().
Expected<geometry::TriangleMesh> readWholeMesh(const std::filesystem::path& file, const ImportOptions& options,
                                               Diagnostics& diagnostics, const SceneBatch* batch = nullptr);

/// The solids of a mesh file as a scene in the file's frame; unnamed ones are called `stem`. An object with several
/// solids becomes an assembly above them. The up axis is z.
ImportedScene sceneOfParts(MeshFileParts file, const std::string& stem);

}  // namespace hapticell::workcell
