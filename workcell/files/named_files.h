// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace hapticell::workcell {

/// The files that a file needs and that are in or below its folder, each once, without the file itself: the material
/// libraries of OBJ (mtllib), buffers and pictures of glTF (uri), the parts that a STEP assembly refers to, and their
/// files. Leaves out names that lead above the folder, and missing files. At most 10 000.
std::vector<std::filesystem::path> filesNamedIn(const std::filesystem::path& file);

}  // namespace hapticell::workcell
