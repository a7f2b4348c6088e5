// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The words after "read FILE" (or "read-all") that pass the options to the importer's process.
std::vector<std::string> importerWords(const ImportOptions& options);

/// Bytes of the file that count for its limits: packed ones tenfold. 0 where there is no such file.
std::uintmax_t bytesToRead(const std::filesystem::path& file);
/// Finer triangles were asked for than usual.
bool isFiner(const ImportOptions& options);

/// The scene of such bytes as readScene() gives it: turned so that z is up. An error names `file`.
Expected<ImportedScene> uprightScene(std::string_view bytes, const std::filesystem::path& file,
                                     const ImportOptions& options);

}  // namespace hapticell::workcell
