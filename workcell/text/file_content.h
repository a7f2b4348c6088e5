// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/system/atomic_file.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// The bytes of a regular file of at most 4 GB. Anything else (missing, a folder, a pipe that would block forever, a
/// file without read permission) is an error that names it.
Expected<std::string> readFileContent(const std::filesystem::path& path);

using hapticell::FileCheck;
using hapticell::FileToWrite;
using hapticell::placeOfFile;
using hapticell::writeFileAtomically;
using hapticell::writeFileChecked;
using hapticell::writeFilesAtomically;

}  // namespace hapticell::workcell
