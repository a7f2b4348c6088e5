// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/system/error.h"

namespace hapticell::workcell {

/// True for names that writeArchive() can write: ".zip", ".tar.gz", ".tgz".
bool isArchiveName(const std::filesystem::path& file);

/// Writes all files below `folder` into an archive, with names relative to it: writes a temporary file, reads it back
/// (checkArchive()) and moves it to `file`. Leaves times and owners out, so the same files give the same bytes. On
/// error, also if the data read back differ, the old file is unchanged.
Expected<void> writeArchive(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace hapticell::workcell
