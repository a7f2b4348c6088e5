// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The entities of a document as a scene in the world's frame: assemblies, solids, and robots (and mechanisms) as
/// assemblies of their links at their present joints. Solids from STEP or IGES keep their origin.
ImportedScene sceneOf(const DocumentState& state);

/// The same for a file in any readable format. `options` as for an import (a robot is at its resting joints). `monitor`
/// may be null.
Expected<ImportedScene> sceneOfFile(const std::filesystem::path& file, const ImportOptions& options,
                                    Diagnostics& diagnostics, ImportMonitor* monitor = nullptr);

/// Extensions of the formats that exportScene() writes: ".step", ".stp", ".glb", ".gltf", ".stl", ".obj", ".ply",
/// ".off".
const std::vector<std::string>& writableExtensions();

struct ExportOptions {
  double metres_per_unit = 1.0;  ///< For STL, OBJ, PLY, OFF; the other formats have their own unit.
  ImportLimits limits = {};
  ImportMonitor* monitor = nullptr;  ///< May be null.
};

/// Writes a document, or the part of it in `state`, like exportScene(); a ".urdf" gets the only robot in it, with the
/// base that it has (writeUrdf()).
Expected<void> exportState(const DocumentState& state, const std::filesystem::path& file, const ExportOptions& options,
                           Diagnostics& diagnostics);

/// Writes a scene in the format that the file's extension names, as a temporary file that is then moved to `file`.
/// STEP: tree, names, colours, placements; exact shapes if a node has an origin, else one plane face per triangle.
/// glTF: tree, names, colours, placements. OBJ: names and colours. PLY, OFF: colours. STL: only triangles.
///
/// Errors: another extension, nothing to write, an original file that is missing or changed, a file that cannot be
/// written, and errors of the importer's process. The old file is then unchanged.
Expected<void> exportScene(const ImportedScene& scene, const std::filesystem::path& file, const ExportOptions& options,
                           Diagnostics& diagnostics);

}  // namespace hapticell::workcell
