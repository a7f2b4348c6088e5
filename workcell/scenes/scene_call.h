// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The arguments after "read FILE" (or "read-all") that pass the options to the importer's process.
std::vector<std::string> importerWords(const ImportOptions& options);

/// Size of the file for its limits, bytes: packed ones count tenfold. 0 if there is no such file.
std::uintmax_t bytesToRead(const std::filesystem::path& file);
/// True if the options ask for finer triangles than usual.
bool isFiner(const ImportOptions& options);

/// The scene from such bytes as readScene() returns it: turned so that z is up. An error names `file`.
Expected<ImportedScene> uprightScene(std::string_view bytes, const std::filesystem::path& file,
                                     const ImportOptions& options);

}  // namespace hapticell::workcell
