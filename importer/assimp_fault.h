// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// A sentence for a file that assimp rejected with `message`: where the fault is, as far as known, what was found and
/// what is expected. Reports a binary glTF file whose length differs from that in its header; replaces messages that
/// only say that no reader accepted the file. `head` is the beginning of the file.
Error assimpFault(const std::filesystem::path& file, std::string_view head, std::string message);

/// The fault of a binary glTF file that is cut off or of an unknown version; empty if it is neither ("glTF 2.0
/// specification", section 4.4).
std::optional<Error> binaryGltfFault(const std::filesystem::path& file, std::string_view head);

}  // namespace hapticell::importer
