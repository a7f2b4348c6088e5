// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/error.h"

namespace hapticell::workcell {

/// The plain URDF of a xacro file, by the user's own program `xacro` (found in PATH), which is given 60 s. Errors: the
/// program is not there (the sentence says how to get it), it fails (its last line is told), its output is no text.
Expected<std::string> expandXacro(const std::filesystem::path& file);

}  // namespace hapticell::workcell
