// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hapticell::workcell {

/// A name for the content of a file: 32 hexadecimal digits, equal for equal bytes and practically never for others.
std::string contentName(std::string_view bytes);

/// The same for the present content of a file; empty if it cannot be read.
std::string contentNameOf(const std::filesystem::path& file);

/// True if the content of a file differs from `known`, the name of what was read or last saved: another program wrote
/// it, and saving would overwrite that, whatever the clocks say. False if the file is gone, or `known` is empty.
bool changedOnDisk(const std::filesystem::path& file, const std::string& known);

}  // namespace hapticell::workcell
