// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hapticell::workcell {

/// A name for the content of a file: 32 hexadecimal digits, equal for equal bytes and practically for no others.
std::string contentName(std::string_view bytes);

/// The same of a file as it stands there; empty where it cannot be read.
std::string contentNameOf(const std::filesystem::path& file);

/// True where a file holds something else than what `known` names, by which it was read or last saved: another program
/// wrote it, and saving would undo that, whatever the clocks say. False where it is gone, or where nothing is known.
bool changedOnDisk(const std::filesystem::path& file, const std::string& known);

}  // namespace hapticell::workcell
