// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "geometry/error.h"

namespace hapticell::workcell {

/// The bytes of a regular file of at most 4 GB. Anything else (missing, a folder, a pipe that would block for ever, a
/// file that may not be read) is an error that names it.
Expected<std::string> readFileContent(const std::filesystem::path& path);

/// Where a file of that name is to be moved: the name itself, or what a symbolic link means. Error: a folder, a pipe or
/// a device stands there, which a file must not take the place of.
Expected<std::filesystem::path> placeOfFile(const std::filesystem::path& path);

/// What looks at a file before it takes its place; its error keeps the file from it.
using FileCheck = std::function<Expected<void>(const std::filesystem::path& written)>;

/// As writeFileAtomically(), but `check` reads the whole file first, under another name with the same extension. Where
/// it finds a fault nothing is left of the file, and what stood there before stands there still.
Expected<void> writeFileChecked(const std::filesystem::path& path, std::string_view content, const FileCheck& check);

/// Writes the file aside, flushes it to the disk and moves it into place: whatever happens, either the old content or
/// the new one stands there. Follows a symbolic link to the file that it means; into what is no regular file (a pipe, a
/// device) it writes as it is.
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace hapticell::workcell
