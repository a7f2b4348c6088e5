// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace hapticell::config {

/// The program folders next to which an installation's files are searched, in this order: that of the running program,
/// then those of the installation whose library contains this function (if another program links it). Absolute paths of
/// folders that exist, each once. From any thread.
std::vector<std::filesystem::path> programFolders();

}  // namespace hapticell::config
