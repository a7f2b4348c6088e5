// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// A sentence for a file that assimp refused with `message`: where the fault is, as far as is known, what was
/// found and what a sound file has. A binary glTF file whose length is not that of its header is reported as such;
/// messages that only say that no reader took it are replaced. `head` is the beginning of the file.
Error assimpFault(const std::filesystem::path& file, std::string_view head, std::string message);

}  // namespace hapticell::importer
