// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace hapticell::config {

/// The folders of programs beside which files of an installation are looked for, in this order: that of the running
/// program, and those of the installation whose library holds this function, where a program of somebody else links it.
/// Absolute paths of folders that exist, each once. From any thread.
std::vector<std::filesystem::path> programFolders();

}  // namespace hapticell::config
