// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/system/error.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

/// xacro::expand() of a file together with the files next to it: includes and YAML are found like meshes
/// (package_path.h); only regular files up to 64 MB are read; bytes that are not UTF-8 are read as Latin-1. An argument
/// that the file does not declare is a warning. Starts no program.
Expected<xacro::Expanded> expandXacroFile(const std::filesystem::path& file, const xacro::Arguments& arguments,
                                          std::vector<xacro::DeclaredArgument>& declared, Diagnostics& diagnostics);

}  // namespace hapticell::workcell
