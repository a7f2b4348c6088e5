// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// A sentence for a file that assimp refused with `message`: where the fault is, as far as is known, what was
/// found and what a sound file has. A binary glTF file whose length is not that of its header is reported as such;
/// messages that only say that no reader took it are replaced. `head` is the beginning of the file.
Error assimpFault(const std::filesystem::path& file, std::string_view head, std::string message);

/// If a binary glTF file is cut off, or of a version that is not known, what is wrong with it ("glTF 2.0
/// specification", section 4.4).
std::optional<Error> binaryGltfFault(const std::filesystem::path& file, std::string_view head);

}  // namespace hapticell::importer
